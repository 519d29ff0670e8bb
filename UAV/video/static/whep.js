// Watch a video by WebRTC. Signalling is the caller's: `ask` sends an offer (SDP) and gives the answer.
//
// All candidates are in the offer, so one request is enough. Nobody else is asked: there is no STUN server, and the
// other end sends where the offer comes from. A viewer wants to see what is now, so the browser is asked not to wait
// for pictures that may come late.
const GATHERING = 1000, CONNECTING = 8000
function gathered(peer) {
  return new Promise(resolve => {
    const look = () => { if (peer.iceGatheringState === 'complete') resolve() }
    peer.addEventListener('icegatheringstatechange', look)
    setTimeout(resolve, GATHERING)
    look()
  })
}

// `watch` is done when a picture is shown, or raises. `ended` is called once when pictures end after that.
export async function watch(video, ask, ended) {
  const peer = new RTCPeerConnection({ iceServers: [] })
  let timer, state = 'connecting'
  const stop = () => {
    clearTimeout(timer)
    peer.close()
    video.srcObject = null
    state = 'ended'
  }
  const lost = () => {
    if (state !== 'shown') return
    stop()
    ended()
  }
  peer.addEventListener('connectionstatechange', () => { if (peer.connectionState === 'failed') lost() })
  peer.addEventListener('track', ({ track, receiver }) => {
    receiver.jitterBufferTarget = receiver.playoutDelayHint = 0
    track.addEventListener('ended', lost)
    video.srcObject = new MediaStream([track])
    video.play().catch(() => {})
  })
  try {
    peer.addTransceiver('video', { direction: 'recvonly' })
    await peer.setLocalDescription()
    await gathered(peer)
    await peer.setRemoteDescription({ type: 'answer', sdp: await ask(peer.localDescription.sdp) })
    await new Promise((resolve, reject) => {
      timer = setTimeout(() => reject(new Error('no picture came by WebRTC')), CONNECTING)
      video.addEventListener('loadeddata', resolve, { once: true })
    })
  } catch (error) {
    stop()
    throw error
  }
  clearTimeout(timer)
  state = 'shown'
  return { peer, stop }
}
