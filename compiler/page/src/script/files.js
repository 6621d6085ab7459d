// Files: what is saved, and a trace that is chosen or dropped.

import { byId } from './dom.js';

/** Hands a text to the user as a file. */
export function save(name, text, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** A name for a file, without what file systems have other uses for. */
export function fileName(chart, ending) {
  const safe = chart.replace(/[^\p{L}\p{N}_-]+/gu, '_').slice(0, 80) || 'chart';
  return `${safe}.${ending}`;
}

/** Calls back with the text of a file that somebody chooses, or drops onto the page. */
export function onFile(take) {
  const field = byId('file');
  const read = async (file) => file && take(await file.text());
  field.addEventListener('change', () => {
    read(field.files[0]);
    field.value = '';
  });
  const curtain = document.querySelector('.drop');
  let depth = 0;
  const isFile = (event) => event.dataTransfer?.types.includes('Files');
  window.addEventListener('dragenter', (event) => {
    if (!isFile(event)) return;
    depth += 1;
    curtain.hidden = false;
  });
  window.addEventListener('dragleave', () => {
    depth = Math.max(0, depth - 1);
    curtain.hidden = depth === 0;
  });
  window.addEventListener('dragover', (event) => isFile(event) && event.preventDefault());
  window.addEventListener('drop', (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    depth = 0;
    curtain.hidden = true;
    read(event.dataTransfer.files[0]);
  });
}
