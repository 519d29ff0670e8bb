// The picture of the large card as a video by WebRTC, where camera, panel and browser have it and UDP reaches; the
// JPEGs where not. They go on until the video shows its first picture, and come back when it shows no more.
//
// A video's last picture looks like a live one. So when the panel gets pictures and none was shown here for two
// seconds, the video is given up, and tried again later, less and less often.
import { h, show } from './parts.js'
import { watch } from './whep.js'

const FROZEN = 2000, AGAIN = 30000, LONGEST = 600000

// A click means the picture that is seen. A JPEG has a number, while a picture of a video has an age, in seconds.
export function ages(video) {
  let shown = 0, received = 0
  function note(now, { receiveTime }) {
    shown = performance.now()
    received = receiveTime ?? now
    video.requestVideoFrameCallback(note)
  }
  if (video.requestVideoFrameCallback) video.requestVideoFrameCallback(note)
  else video.addEventListener('timeupdate', () => { shown = received = performance.now() })
  const begin = () => { shown = received = performance.now() }
  return { begin, frozen: () => performance.now() - shown > FROZEN, age: () => (performance.now() - received) / 1000 }
}

export function liveVideo(row, jpeg) {
  const node = h('video', { muted: true, autoplay: true, playsinline: true, 'aria-label': 'Live picture' })
  const times = ages(node)
  let session = null, trying = false, led = false, status = null, pause = AGAIN, again = 0, timer
  node.muted = true
  show(node, false)
  node.addEventListener('resize', () => { if (session) jpeg.image.size = [node.videoWidth, node.videoHeight] })
  const able = () => !!row.wire.watch && !!status?.picture.webrtc && status.state === 'alive'
  const wanted = () => led && !document.hidden && able()
  function end() {
    clearInterval(timer)
    session?.stop()
    if (session) jpeg.forget()
    session = null
    show(node, false)
  }
  function failed() {
    end()
    again = performance.now() + pause
    setTimeout(look, pause)
    pause = Math.min(LONGEST, 2 * pause)
  }
  async function begin() {
    trying = true
    node.classList.add('trying')
    show(node, true)
    try {
      const begun = await watch(node, offer => row.wire.watch(row.of, offer), failed)
      if (!wanted()) return show(node, false, begun.stop())
      session = begun
      pause = AGAIN
      times.begin()
      timer = setInterval(() => { if (status.picture.state === 'running' && times.frozen()) failed() }, FROZEN / 4)
      jpeg.clear([node.videoWidth, node.videoHeight])
      node.classList.remove('trying')
    } catch { failed() } finally { trying = false }
  }
  function look() {
    if (session && !wanted()) end()
    else if (!session && !trying && wanted() && performance.now() >= again) begin()
  }
  function update(now) {
    status = now
    look()
  }
  function lead(main) {
    led = main
    look()
  }
  function stop() {
    led = false
    document.removeEventListener('visibilitychange', look)
    end()
  }
  document.addEventListener('visibilitychange', look)
  return { node, update, lead, stop, on: () => !!session, age: times.age }
}
