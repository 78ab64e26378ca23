// Numbers over the last hour.
import uPlot from 'uplot';
import type { Participant, Status } from './answers.js';
import { h } from './dom.js';
import type { History } from './history.js';
import { hour } from './team.js';
import { clock } from './time.js';

/** Between two samples, in milliseconds. */
export const sampleEach = 2000;
const maxSamples = hour / sampleEach;

const curves = [
  { title: 'Services and requests', labels: ['services', 'requests', 'not served'], colours: ['--exact', '--narrower', '--bad'] },
  { title: 'Loss, worst and mean, in %', labels: ['worst', 'mean'], colours: ['--bad', '--exact'] },
  { title: 'Datagrams heard a second', labels: ['datagrams'], colours: ['--exact'] },
];

const height = 130;
/** Seconds that a curve shows at least. */
const leastSpan = 60;
/** The width that the figure around an element leaves. */
const widthOf = (element: Element): number => Math.max(200, element.parentElement?.clientWidth ?? 0);

export class Curves {
  private readonly times: number[] = [];
  private readonly values: (number | null)[][] = [[], [], [], [], [], []];
  private plots: uPlot[] = [];
  private former: { time: number; datagrams: number } | undefined;

  constructor(private readonly parent: HTMLElement) {
    this.build();
    new ResizeObserver(() => {
      for (const plot of this.plots) plot.setSize({ width: widthOf(plot.root), height });
    }).observe(parent);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.build());
  }

  /** One sample; without a status the daemon is away, and the curves have a hole. */
  add(time: number, status: Status | undefined, participants: Participant[], unserved: number): void {
    const losses = participants.filter((one) => !one.self).map((one) => (one.loss ?? 0) * 100);
    const heard = status === undefined ? null : this.rate(time, status.datagrams_received);
    if (status === undefined) this.former = undefined;
    const sample = status === undefined ? [null, null, null, null, null, null] : [
      status.publications, status.subscriptions, unserved, Math.max(0, ...losses),
      losses.length === 0 ? 0 : losses.reduce((sum, loss) => sum + loss, 0) / losses.length,
      heard,
    ];
    this.times.push(time / 1000);
    sample.forEach((value, at) => this.values[at]?.push(value));
    while (this.times.length > maxSamples || (this.times[0] ?? 0) < (time - hour) / 1000) for (const column of [this.times, ...this.values]) column.shift();
    this.show();
  }

  /** Takes the samples that geminga-web has kept, behind those that are known. */
  recall(samples: History['samples']): void {
    this.former = undefined;
    const known = this.times.at(-1) ?? 0;
    for (const [at, services, requests, unserved, worst, mean, datagrams] of samples) {
      const time = Date.parse(at);
      if (time / 1000 <= known) continue;
      const rate = this.rate(time, datagrams);
      this.times.push(time / 1000);
      [services, requests, unserved, worst * 100, mean * 100, rate].forEach((value, column) => this.values[column]?.push(value));
    }
    this.former = undefined;
    if (samples.length > 0) this.show();
  }

  /** Datagrams a second since the former sample; null where there is none, or the daemon began to count anew. */
  private rate(time: number, datagrams: number): number | null {
    const seconds = this.former === undefined ? 0 : (time - this.former.time) / 1000;
    const rate = this.former === undefined || seconds <= 0 ? null : (datagrams - this.former.datagrams) / seconds;
    this.former = { time, datagrams };
    return rate === null || rate < 0 ? null : rate;
  }

  private columns(at: number): uPlot.AlignedData {
    const first = curves.slice(0, at).reduce((sum, one) => sum + one.labels.length, 0);
    return [this.times, ...this.values.slice(first, first + (curves[at]?.labels.length ?? 0))] as uPlot.AlignedData;
  }

  private show(): void {
    this.plots.forEach((plot, at) => plot.setData(this.columns(at)));
  }

  private build(): void {
    for (const plot of this.plots) plot.destroy();
    const style = getComputedStyle(document.documentElement);
    const colour = (name: string) => style.getPropertyValue(name).trim();
    const axis = { stroke: colour('--quiet'), grid: { stroke: colour('--line'), width: 1 }, ticks: { stroke: colour('--line') }, font: '12px system-ui, sans-serif' };
    this.parent.replaceChildren();
    this.plots = curves.map((curve, at) => {
      const figure = h('figure', {}, h('figcaption', {}, curve.title));
      this.parent.append(figure);
      return new uPlot({
        width: widthOf(figure.firstElementChild ?? figure), height, cursor: { y: false }, legend: { live: true, isolate: false },
        scales: { x: { range: (_plot, low, high) => [Math.min(low ?? 0, (high ?? 0) - leastSpan), high ?? leastSpan] }, y: { range: (_plot, _low, high) => [0, Math.max(1, (high ?? 0) * 1.1)] } },
        axes: [{ ...axis, space: 70, values: (_plot, splits) => splits.map((second) => (this.times.length === 0 ? '' : clock(second * 1000))) }, { ...axis, size: 44 }],
        series: [{ label: 'at', value: (_plot: uPlot, value: number | null) => (value === null ? '–' : clock(value * 1000)) }, ...curve.labels.map((label, one) => ({
          label, points: { show: false }, stroke: colour(curve.colours[one] ?? '--exact'), width: 1.8, dash: one === 1 ? [6, 4] : one === 2 ? [2, 3] : [],
          value: (_plot: uPlot, value: number | null) => (value === null ? '–' : value.toFixed(value < 10 ? 1 : 0)),
        }))],
      }, this.columns(at), figure);
    });
  }
}
