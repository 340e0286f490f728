// SPDX-License-Identifier: Apache-2.0
// Saves a record as one HTML file that plays it anywhere, without SEAR and network. The file contains poses, models,
// pictures, three.js, and this panel's drawing modules.
import {fileName, saveText} from '../shared/words.js'

const MOST = 24e6             // maximum file size, characters
const PLAYER = 'run/player.js'
const AT_ONCE = 60            // looks requested together
const PATIENCE_MILLIS = 30000
const MOST_SECONDS = 600      // maximum duration of a record that is rerun for its beams and wheels
const IMPORT = /^import (.+) from '([^']+)'$/gm

function textOf(url) {
    return fetch(url).then(answer => {
        if (!answer.ok) {
            throw new Error(url + ' answered ' + answer.status)
        }
        return answer.text()
    })
}
/** Escapes text for a script element. */
function safe(text) {
    return text.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--')
}
/** Returns JSON that can't end a script element. */
function json(what) {
    return JSON.stringify(what).replace(/</g, '\\u003c')
}
function escaped(text) {
    return text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;')
}

/**
 * Returns a module and all of its imports, each as a function, in order.
 * @param made names of modules already included
 */
function bundle(name, made) {
    if (made.indexOf(name) >= 0) {
        return Promise.resolve('')
    }
    made.push(name)
    return textOf(new URL('../' + name, import.meta.url)).then(text => {
        const before = []
        let body = text.replace(IMPORT, (all, what, path) => {
            const other = new URL(path, 'http://x/' + name).pathname.slice(1)
            before.push(other)
            return 'var ' + what.replace(/^\* as /, '').replace(/ as /g, ': ') + ' = modules[\'' + other + '\']'
        })
        const names = Array.from(body.matchAll(/^export (?:function|class|const) (\w+)/gm)).map(found => found[1])
        body = '\nmodules[\'' + name + '\'] = (function() {\n' + body.replace(/^export /gm, '') + '\nreturn {'
        + names.join(', ') + '}\n})()\n'
        return before.reduce((done, other) => done.then(already => bundle(other, made).then(more => already + more)),
            Promise.resolve(''))
            .then(first => first + body)
    })
}

/** Fills a page template. @param form the template, see player.html @param parts by the name of a place in it */
function page(form, parts) {
    return form.replace(/@(\w+)@/g, (all, name) => parts[name])
}

/** The sharing controls of one panel. */
export class Share {
    constructor(panel, messages, replay, ground) {
        this.panel = panel
        this.messages = messages
        this.replay = replay
        this.ground = ground
        this.looks = null       // received looks and pictures, by key; null while nothing is shared
        this.missing = null     // keys not received yet
        this.since = 0
        this.motion = null      // wheel rotations and sensor readings, or {why: there are none}; null while awaited
        this.waiting = null     // timeout of the motion
        this.busy = false
        this.handlers = {onRecordMotion: sent => sent && this.busy && sent.path === this.shown.path
            && this.takeMotion(sent)}
    }

    record() {
        if (!this.replay.shown || this.busy) {
            return
        }
        this.busy = true
        this.looks = {}
        this.missing = {}
        this.shown = this.replay.shown
        this.terrain = this.ground.of(this.shown.world)
        this.shown.world.objects.concat.apply(this.shown.world.objects,
            this.shown.world.robots.map(robot => robot.parts)).forEach(one => {
            if (one.look) {
                this.missing[one.look + '/0'] = true
            }
            if (one.picture) {
                this.missing['picture ' + one.picture] = true
            }
        })
        this.askForMotion()
    }

    /** Has the service rerun the record for its motion; without it the record is shared anyway. */
    askForMotion() {
        const times = this.shown.times
        this.motion = null
        if (times[times.length - 1] - times[0] > MOST_SECONDS) {
            this.takeMotion({why: 'the record is longer than ' + MOST_SECONDS / 60 + ' minutes'})
            return
        }
        this.panel.msg.send('getRecordMotion', this.shown.path)
        this.waiting = this.panel.timeout(() => {
            this.takeMotion({why: 'the rerun of the record took too long'})
        }, 2 * PATIENCE_MILLIS)
    }

    takeMotion(sent) {
        if (this.busy && !this.motion) {
            this.panel.timeout.cancel(this.waiting)
            this.motion = sent
            this.ask()
        }
    }

    ask() {
        const keys = Object.keys(this.missing)
        this.since = Date.now()
        if (keys.length) {
            this.panel.msg.send('getLooks', keys.slice(0, AT_ONCE))
            this.panel.timeout(() => {
                if (this.busy && Date.now() - this.since >= PATIENCE_MILLIS) {
                    this.fail('no answer with the models and pictures')
                }
            }, PATIENCE_MILLIS)
        } else {
            this.write().catch(error => this.fail(error.message)).then(() => {
                this.busy = false
                this.panel.scope.$applyAsync()
            })
        }
    }

    fail(why) {
        this.busy = false
        this.messages.say('error', 'sharing failed: ' + why)
    }

    /** Takes models and pictures, requested by this panel or another. */
    take(sent) {
        if (!this.busy) {
            return
        }
        let news = false
        angular.forEach(sent, one => {
            if (this.missing[one.key]) {
                delete this.missing[one.key]
                this.looks[one.key] = one
                news = true
                for (let i = 1; i < one.parts; i++) {
                    const other = one.key.slice(0, one.key.lastIndexOf('/') + 1) + i
                    if (!this.looks[other]) {
                        this.missing[other] = true
                    }
                }
            }
        })
        if (news) {
            this.ask()
        }
    }

    write() {
        const record = this.shown
        const title = fileName(record.path).replace(/\.searlog$/, '')
        const source = Array.from(document.scripts).filter(script => /\/three(\.min)?\.js$/.test(script.src)
            && script.src.indexOf('widget') < 0)[0]
        const run = {title, looks: this.looks, terrain: this.terrain && this.terrain.sent,
            world: this.plain(record.world),
            motion: this.motion.frames ? this.motion : null,
            record: {times: record.times, robots: record.robots, objects: record.objects, robotPoses: record.robotPoses,
                objectPoses: record.objectPoses, speeds: record.speeds, lights: record.lights,
                    brightness: record.brightness}}
        const form = new URL('player.html', import.meta.url)
        return Promise.all([textOf(form), textOf(source.src), bundle(PLAYER, [])]).then(parts => {
            const text = page(parts[0], {title: escaped(title), three: safe(parts[1]), modules: safe(parts[2]),
                run: json(run)})
            const size = (text.length / 1e6).toFixed(1) + ' MB'
            if (text.length > MOST) {
                throw new Error('the file is too large: ' + size + ', legal: at most ' + MOST / 1e6
                    + ' MB; share a shorter record, or a world with fewer and simpler models')
            }
            saveText(title + '.html', text)
            this.messages.say('info', 'saved the run as ' + title + '.html, ' + size + ': it opens in any browser, '
                + 'without SEAR'
                + (this.motion.why ? '; without beams and wheel rotation: ' + this.motion.why : ''))
        })
    }

    /** Returns a world without this page's own data. */
    plain(world) {
        return JSON.parse(JSON.stringify({time: 0, sensors: [], objects: world.objects, robots: world.robots},
            (key, value) => key === '$shape' || key === '$$hashKey' || key === 'path' ? undefined : value))
    }
}
