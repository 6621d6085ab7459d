// What a served page has beyond one in a file: it is loaded again when its chart is saved, and shows errors over the last
// good drawing. Before it stands `own`, the version of the chart that it is of.

const panel = document.createElement('section');
panel.id = 'live';
panel.hidden = true;
panel.setAttribute('role', 'alert');
panel.style.cssText =
  'position:fixed;left:16px;right:16px;bottom:16px;z-index:99;max-height:45vh;overflow:auto;padding:12px 16px;' +
  'border:2px solid var(--bad);border-radius:8px;background:var(--panel);color:var(--ink);box-shadow:0 6px 30px #0006';
const title = panel.appendChild(document.createElement('strong'));
const list = panel.appendChild(document.createElement('pre'));
list.style.cssText = 'margin:8px 0 0;font:13px/1.4 ui-monospace,monospace;white-space:pre';
document.body.append(panel);

function show(key, text) {
  panel.hidden = key === null;
  if (key === null) return;
  title.textContent = window.grafc.word(key);
  list.textContent = text;
  list.hidden = text === '';
}

const news = new EventSource('/events');
news.onmessage = ({ data }) => {
  const { page, errors } = JSON.parse(data);
  show(errors === null ? null : 'served-errors', errors ?? '');
  if (page !== null && page !== own) {
    sessionStorage.setItem('grafc-keep', JSON.stringify(window.grafc.keep()));
    location.reload();
  }
};
// It tries again by itself.
news.onerror = () => show('served-ended', '');
