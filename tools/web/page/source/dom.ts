// Elements from code. Text is textContent and nothing else, so that a name from outside can be no markup.

type Child = Node | string;
type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

function filled<E extends Element>(element: E, attributes: Attributes, children: Child[]): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

export function h<Tag extends keyof HTMLElementTagNameMap>(tag: Tag, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[Tag] {
  return filled(document.createElement(tag), attributes, children);
}

export function svg<Tag extends keyof SVGElementTagNameMap>(tag: Tag, attributes: Attributes = {}, ...children: Child[]): SVGElementTagNameMap[Tag] {
  return filled(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

export function byId(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (element === null) throw new Error(`the page has no #${id}`);
  return element;
}

/** The part of a section below its heading. */
export function bodyOf(id: string): HTMLElement {
  const body = byId(id).querySelector<HTMLElement>('.body');
  if (body === null) throw new Error(`#${id} has no body`);
  return body;
}

/** Elements by key that stay as long as what they were made of is the same, so that a drawing costs what has changed. */
export class Kept<E extends Element> {
  private known = new Map<string, { of: string; element: E }>();
  private next = new Map<string, { of: string; element: E }>();

  take(key: string, of: string, make: () => E): E {
    const known = this.known.get(key);
    const kept = known?.of === of ? known : { of, element: make() };
    this.next.set(key, kept);
    return kept.element;
  }

  /** Ends a drawing: the elements that were taken are the children of `parent`, in their order. */
  put(parent: Element): void {
    const elements = [...this.next.values()].map((one) => one.element);
    this.known = this.next;
    this.next = new Map();
    const isSame = elements.length === parent.children.length && elements.every((element, at) => parent.children[at] === element);
    if (!isSame) refill(parent, ...elements);
  }
}

/** Replaces what is in an element, and keeps the focus where an element of the same data-key comes again. */
export function refill(parent: Element, ...children: Child[]): void {
  const focused = document.activeElement;
  const key = focused !== null && parent.contains(focused) ? focused.getAttribute('data-key') : null;
  parent.replaceChildren(...children);
  if (key !== null) parent.querySelector<HTMLElement>(`[data-key="${CSS.escape(key)}"]`)?.focus({ preventScroll: true });
}

export const counted = (count: number, word: string): string => `${count} ${word}${count === 1 ? '' : 's'}`;

export const shortened = (text: string, length: number): string => (text.length <= length ? text : text.slice(0, length - 1) + '…');
