// A page with nothing but the picture. It comes back by itself, and says why there is none.
import { watch } from './whep.js'

const video = document.querySelector('video'), words = document.querySelector('p')
const token = new URLSearchParams(location.hash.slice(1)).get('token')
const headers = token ? { Authorization: 'Bearer ' + token } : {}
const later = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds))
let session = null

async function ask(sdp) {
  const about = { method: 'POST', headers: { ...headers, 'Content-Type': 'application/sdp' }, body: sdp }
  const answer = await fetch(document.body.dataset.whep, about), text = await answer.text()
  if (answer.status !== 201) throw new Error(text)
  session = new URL(answer.headers.get('Location'), answer.url)
  return text
}

function leave() {
  if (session) fetch(session, { method: 'DELETE', headers, keepalive: true }).catch(() => {})
  session = null
}

const say = text => { words.textContent = text }
window.addEventListener('pagehide', leave)
window.addEventListener('pageshow', event => { if (event.persisted) location.reload() })
for (let pause = 500; ; pause = Math.min(5000, 2 * pause)) {
  try {
    await new Promise((resolve, reject) => {
      const shown = () => { pause = 250; say('') }
      watch(video, ask, resolve).then(shown, reject)
    })
    say('The picture is lost')
  } catch (error) { say(error instanceof TypeError ? 'No link to the camera' : error.message) }
  leave()
  await later(pause)
}
