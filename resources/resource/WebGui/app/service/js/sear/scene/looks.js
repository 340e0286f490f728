// SPDX-License-Identifier: Apache-2.0
// Models and pictures of shapes for the SEAR panel's 3D view, each requested when first needed. The Java class
// LookTable documents the data format.
const KEYS_AT_ONCE = 60
const PATIENCE_MILLIS = 10000 // timeout: requests it again
const MOST_SAMPLES = 8

function numbers(Type, base64) {
    const text = window.atob(base64)
    const bytes = new Uint8Array(text.length)
    for (let i = 0; i < text.length; i++) {
        bytes[i] = text.charCodeAt(i)
    }
    return new Type(bytes.buffer)
}

function surface(part) {
    const THREE = window.THREE
    const packed = numbers(window.Uint16Array, part.positions)
    const signed = numbers(window.Int8Array, part.normals)
    const positions = new window.Float32Array(packed.length)
    const normals = new window.Float32Array(packed.length)
    for (let i = 0; i < packed.length; i++) {
        positions[i] = part.low[i % 3] + packed[i] * (part.high[i % 3] - part.low[i % 3]) / 65535
        normals[i] = signed[i] / 127
    }
    const made = new THREE.BufferGeometry()
    made.addAttribute('position', new THREE.BufferAttribute(positions, 3))
    made.addAttribute('normal', new THREE.BufferAttribute(normals, 3))
    made.addAttribute('uv', new THREE.BufferAttribute(numbers(window.Float32Array, part.pictures), 2))
    return made
}

/**
 * @param ask requests looks and pictures by their keys
 * @param whenThere called when some have arrived
 * @param smooth the graphics card's maximum anisotropy
 */
export class Looks {
    constructor(ask, whenThere, smooth) {
        this.ask = ask
        this.whenThere = whenThere
        this.smooth = Math.min(MOST_SAMPLES, smooth)
        this.looks = {}             // by number of the look: its received parts
        this.textures = {}          // by path of the picture: texture, or null if it can't be shown
        this.wanted = {}            // requested keys, and when they were requested
    }

    /** Returns the parts of a look; null until all are there. */
    look(id) {
        const look = this.looks[id]
        if (!look) {
            this.wanted[id + '/0'] = this.wanted[id + '/0'] || 0
            return null
        }
        for (let i = 0; i < look.length; i++) {
            if (!look[i]) {
                this.wanted[id + '/' + i] = this.wanted[id + '/' + i] || 0
                return null
            }
        }
        return look
    }

    /** Returns the texture of a picture; undefined until it is there, null if it can't be shown. */
    texture(path) {
        if (!Object.prototype.hasOwnProperty.call(this.textures, path)) {
            this.wanted['picture ' + path] = this.wanted['picture ' + path] || 0
        }
        return this.textures[path]
    }

    want() {
        const now = Date.now()
        let keys = Object.keys(this.wanted)
        const open = keys.some(key => this.wanted[key] && now - this.wanted[key] < PATIENCE_MILLIS)
        if (!open && keys.length) {
            keys = keys.slice(0, KEYS_AT_ONCE)
            keys.forEach(key => {
                this.wanted[key] = now
            })
            this.ask(keys)
        }
    }

    /** Takes what the service has sent, for this page or another one. */
    take(sent) {
        angular.forEach(sent, one => {
            if (Object.prototype.hasOwnProperty.call(this.wanted, one.key)) {
                delete this.wanted[one.key]
                if (one.positions) {
                    const at = one.key.lastIndexOf('/')
                    const id = one.key.slice(0, at)
                    this.looks[id] = this.looks[id] || new Array(one.parts).fill(null)
                    this.looks[id][Number(one.key.slice(at + 1))] = surface(one)
                } else {
                    this.takePicture(one)
                }
            }
        })
        this.wanted = {}            // shapes that still lack something ask again; those of a replaced world do not
        this.whenThere()
    }

    takePicture(sent) {
        const THREE = window.THREE
        const path = sent.key.slice('picture '.length)
        if (!sent.data) {
            this.textures[path] = null
            return
        }
        const image = new window.Image()
        image.onload = () => {
            const texture = new THREE.Texture(image)
            const round = (image.width & image.width - 1) === 0 && (image.height & image.height - 1) === 0
            texture.wrapS = texture.wrapT = THREE.RepeatWrapping
            if (!round) {
                texture.image = squared(image)      // WebGL 1 repeats only power-of-two textures
            }
            texture.anisotropy = this.smooth
            texture.needsUpdate = true
            this.textures[path] = texture
            this.whenThere()
        }
        image.onerror = () => {
            this.textures[path] = null
            this.whenThere()
        }
        image.src = sent.data
    }
}

/** Scales a picture to sides that are powers of two. */
function squared(image) {
    const canvas = document.createElement('canvas')
    canvas.width = Math.pow(2, Math.round(Math.log(image.width) / Math.LN2))
    canvas.height = Math.pow(2, Math.round(Math.log(image.height) / Math.LN2))
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height)
    return canvas
}
