// SPDX-License-Identifier: Apache-2.0
// Texts of the SEAR panel, and files that it saves in the browser.
export function count(number, thing) {
    return number + ' ' + thing + (number === 1 ? '' : 's')
}

// Names of parameters whose parts say too little.
const PARAMETERS = {rx: 'turn about x', ry: 'turn about y', rz: 'turn about z',
    onGround: 'on the ground', scaleX: 'scale along x', scaleY: 'scale along y', scaleZ: 'scale along z',
    placeLatitude: 'latitude', placeLongitude: 'longitude', placeHeading: 'heading'}

/** Returns a parameter's name in words: maxSuspensionForce is max suspension force. */
export function parameterWords(name) {
    const lower = (all, end, start) => end + ' ' + start.toLowerCase()
    return PARAMETERS[name] || name.replace(/([a-z0-9])([A-Z])(?![A-Z])/g, lower).replace(/([a-z0-9])([A-Z])/g, '$1 $2')
}

// ---- files
// ---------------------------------------------------------------------------------------------------------------------
function bytes(base64) {
    return Uint8Array.from(window.atob(base64), one => one.charCodeAt(0))
}

/** Returns the last part of a path. */
export function fileName(path) {
    return path.split(/[\\/]/).pop()
}

/** Saves a file in the browser. @param parts of it, in base64 */
export function saveFile(name, parts) {
    saveBlob(name, new Blob(parts.map(bytes), {type: 'application/zip'}))
}
export function saveText(name, text) {
    saveBlob(name, new Blob([text], {type: 'text/plain'}))
}
export function saveBlob(name, blob) {
    const link = document.createElement('a')
    link.href = window.URL.createObjectURL(blob)
    link.download = name
    document.body.appendChild(link)
    link.click()
    document.body.removeChild(link)
    setTimeout(() => {
        window.URL.revokeObjectURL(link.href)
    }, 60000)
}
