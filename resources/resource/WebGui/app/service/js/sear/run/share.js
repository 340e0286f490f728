// SPDX-License-Identifier: Apache-2.0
// Saves a record as one HTML file that plays it anywhere, without SEAR and network. The file contains poses, models,
// pictures, three.js, and this panel's drawing modules.
import {fileName, saveText} from '../shared/words.js'

var MOST = 24e6             // maximum file size, characters
var PLAYER = 'run/player.js'
var AT_ONCE = 60            // looks requested together
var PATIENCE_MILLIS = 30000
var MOST_SECONDS = 600      // maximum duration of a record that is rerun for its beams and wheels
var IMPORT = /^import (.+) from '([^']+)'$/gm

function textOf(url) {
    return fetch(url).then(function(answer) {
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
    return textOf(new URL('../' + name, import.meta.url)).then(function(text) {
        var before = []
        var body = text.replace(IMPORT, function(all, what, path) {
            var other = new URL(path, 'http://x/' + name).pathname.slice(1)
            before.push(other)
            return 'var ' + what.replace(/^\* as /, '').replace(/ as /g, ': ') + ' = modules[\'' + other + '\']'
        })
        var names = Array.from(body.matchAll(/^export (?:function|var) (\w+)/gm)).map(found => found[1])
        body = '\nmodules[\'' + name + '\'] = (function() {\n' + body.replace(/^export /gm, '') + '\nreturn {' + names.join(', ') + '}\n})()\n'
        return before.reduce(function(done, other) {
            return done.then(already => bundle(other, made).then(more => already + more))
        }, Promise.resolve('')).then(first => first + body)
    })
}

/** Fills a page template. @param form the template, see player.html @param parts by the name of a place in it */
function page(form, parts) {
    return form.replace(/@(\w+)@/g, (all, name) => parts[name])
}

/** Makes the sharing controls of one panel. */
export function makeShare(panel, messages, replay, ground) {
    var looks = null            // received looks and pictures, by key; null while nothing is shared
    var missing = null          // keys not received yet
    var since = 0
    var motion = null           // wheel rotations and sensor readings, or {why: there are none}; null while awaited
    var waiting = null          // timeout of the motion
    var share = {busy: false}

    share.record = function() {
        if (!replay.shown || share.busy) {
            return
        }
        share.busy = true
        looks = {}
        missing = {}
        share.shown = replay.shown
        share.terrain = ground.of(share.shown.world)
        share.shown.world.objects.concat.apply(share.shown.world.objects, share.shown.world.robots.map(robot => robot.parts)).forEach(function(one) {
            if (one.look) {
                missing[one.look + '/0'] = true
            }
            if (one.picture) {
                missing['picture ' + one.picture] = true
            }
        })
        askForMotion()
    }
    /** Has the service rerun the record for its motion; without it the record is shared anyway. */
    function askForMotion() {
        var times = share.shown.times
        motion = null
        if (times[times.length - 1] - times[0] > MOST_SECONDS) {
            takeMotion({why: 'the record is longer than ' + MOST_SECONDS / 60 + ' minutes'})
            return
        }
        panel.msg.send('getRecordMotion', share.shown.path)
        waiting = panel.timeout(function() {
            takeMotion({why: 'the rerun of the record took too long'})
        }, 2 * PATIENCE_MILLIS)
    }
    function takeMotion(sent) {
        if (share.busy && !motion) {
            panel.timeout.cancel(waiting)
            motion = sent
            ask()
        }
    }
    share.handlers = {onRecordMotion: sent => sent && share.busy && sent.path === share.shown.path && takeMotion(sent)}
    function ask() {
        var keys = Object.keys(missing)
        since = Date.now()
        if (keys.length) {
            panel.msg.send('getLooks', keys.slice(0, AT_ONCE))
            panel.timeout(function() {
                if (share.busy && Date.now() - since >= PATIENCE_MILLIS) {
                    fail('no answer with the models and pictures')
                }
            }, PATIENCE_MILLIS)
        } else {
            write().catch(error => fail(error.message)).then(function() {
                share.busy = false
                panel.scope.$applyAsync()
            })
        }
    }
    function fail(why) {
        share.busy = false
        messages.say('error', 'sharing failed: ' + why)
    }
    /** Takes models and pictures, requested by this panel or another. */
    share.take = function(sent) {
        if (!share.busy) {
            return
        }
        var news = false
        angular.forEach(sent, function(one) {
            if (missing[one.key]) {
                delete missing[one.key]
                looks[one.key] = one
                news = true
                for (var i = 1; i < one.parts; i++) {
                    var other = one.key.slice(0, one.key.lastIndexOf('/') + 1) + i
                    if (!looks[other]) {
                        missing[other] = true
                    }
                }
            }
        })
        if (news) {
            ask()
        }
    }
    function write() {
        var record = share.shown
        var title = fileName(record.path).replace(/\.searlog$/, '')
        var source = Array.from(document.scripts).filter(script => /\/three(\.min)?\.js$/.test(script.src) && script.src.indexOf('widget') < 0)[0]
        var run = {title: title, looks: looks, terrain: share.terrain && share.terrain.sent, world: plain(record.world),
            motion: motion.frames ? motion : null,
            record: {times: record.times, robots: record.robots, objects: record.objects, robotPoses: record.robotPoses,
                objectPoses: record.objectPoses, speeds: record.speeds, lights: record.lights, brightness: record.brightness}}
        var form = new URL('player.html', import.meta.url)
        return Promise.all([textOf(form), textOf(source.src), bundle(PLAYER, [])]).then(function(parts) {
            var text = page(parts[0], {title: escaped(title), three: safe(parts[1]), modules: safe(parts[2]), run: json(run)})
            var size = (text.length / 1e6).toFixed(1) + ' MB'
            if (text.length > MOST) {
                throw new Error('the file is too large: ' + size + ', legal: at most ' + MOST / 1e6
                    + ' MB; share a shorter record, or a world with fewer and simpler models')
            }
            saveText(title + '.html', text)
            messages.say('info', 'saved the run as ' + title + '.html, ' + size + ': it opens in any browser, without SEAR'
                + (motion.why ? '; without beams and wheel rotation: ' + motion.why : ''))
        })
    }
    /** Returns a world without this page's own data. */
    function plain(world) {
        return JSON.parse(JSON.stringify({time: 0, sensors: [], objects: world.objects, robots: world.robots},
            (key, value) => key === '$shape' || key === '$$hashKey' || key === 'path' ? undefined : value))
    }
    return share
}
