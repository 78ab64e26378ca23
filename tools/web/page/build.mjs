// The page as one file: `node build.mjs FILE`. The script and the style stand in it, and its policy admits these two by their hashes and
// nothing else. The same sources and packages give the same octets.
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const maxPackedOctets = 150 * 1024;
const options = { bundle: true, minify: true, write: false, charset: 'utf8', legalComments: 'inline', target: 'es2022', absWorkingDir: here };

async function bundled(entry, more) {
  const result = await build({ ...options, ...more, entryPoints: [entry] });
  return result.outputFiles[0].text.trim();
}

/** The licences of what is bundled, which its authors ask to be handed on with it. */
const bundledPackages = ['uplot', 'd3-force', 'd3-dispatch', 'd3-quadtree', 'd3-timer'];
const licences = bundledPackages
  .map((name) => `${name}: ${readFileSync(join(here, 'node_modules', name, 'LICENSE'), 'utf8').trim()}`)
  .join('\n\n')
  .replaceAll('--', '- -');

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const script = await bundled('source/main.ts', { format: 'iife' });
const style = await bundled('source/style.css', {});
if (script.includes('</script') || style.includes('</style')) throw new Error('the bundle would end its own element');
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)}`,
  `style-src ${hash(style)}`,
  "connect-src 'self'",
  'img-src data:',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');
const page = readFileSync(join(here, 'source/index.html'), 'utf8')
  .replace('{licences}', () => licences)
  .replace('{policy}', () => policy)
  .replace('{style}', () => style)
  .replace('{script}', () => script);
const packed = gzipSync(page, { level: 9 }).length;
if (packed > maxPackedOctets) throw new Error(`the page has ${packed} octets packed: ${maxPackedOctets} are allowed`);
writeFileSync(process.argv[2] ?? join(here, 'page.html'), page);
console.log(`${page.length} characters, ${packed} octets packed`);
