// Writes a record as one HTML file that plays it anywhere, without SEAR and without network: what was where, what things look like, three.js, and the
// modules of this panel that draw.
import {fileName, saveText} from '../shared/words.js'

var MOST = 24e6             // characters of the file
var PLAYER = 'run/player.js'
var AT_ONCE = 60            // looks that are asked for together
var PATIENCE_MILLIS = 30000
var IMPORT = /^import (.+) from '([^']+)'$/gm

function textOf(url) {
    return fetch(url).then(function(answer) {
        if (!answer.ok) {
            throw new Error(url + ' answered ' + answer.status)
        }
        return answer.text()
    })
}
/** As it may stand in a script of a page. */
function safe(text) {
    return text.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--')
}
/** JSON in which nothing ends a script. */
function json(what) {
    return JSON.stringify(what).replace(/</g, '\\u003c')
}
function escaped(text) {
    return text.replace(/&/g, '&amp;').replace(/</g, '&lt;')
}

/** A module and all that it imports, each as the function that it becomes, in order. @param made names of those that are there */
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

function page(title, three, modules, run) {
    return '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        + '<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>'
        + escaped(title) + '</title>\n<style>\n:root { color-scheme: light dark; }\n'
        + 'html, body { height: 100%; margin: 0; font: 14px system-ui, sans-serif; }\nbody { display: flex; flex-direction: column; }\n'
        + '#view { flex: 1 1 0; min-height: 0; width: 100%; touch-action: none; }\n'
        + '#bar { display: flex; flex-wrap: wrap; align-items: center; gap: 6px 10px; padding: 8px 12px; }\n'
        + '#slider { flex: 1 1 160px; }\n#time { font-variant-numeric: tabular-nums; }\n#bar button { min-width: 5em; }\n</style>\n</head>\n<body>\n'
        + '<canvas id="view" role="img" aria-label="' + escaped(title).replace(/"/g, '&quot;') + '"></canvas>\n<div id="bar">\n'
        + '<button id="play" type="button">Play</button>\n'
        + '<input id="slider" type="range" min="0" value="0" aria-label="Time">\n<span id="time"></span>\n'
        + '<select id="speed" aria-label="Speed"><option value="0.25">¼ ×</option><option value="1" selected>real time</option>'
        + '<option value="4">4 ×</option><option value="20">20 ×</option></select>\n'
        + '<label><input id="follow" type="checkbox"> follow</label>\n<strong>' + escaped(title) + '</strong>\n</div>\n'
        + '<p id="failed" role="alert" hidden>This browser has no WebGL, which the animation needs.</p>\n'
        + '<script>' + safe(three) + '</script>\n<script id="run" type="application/json">' + json(run) + '</script>\n<script>\n'
        + 'var angular = {forEach: function(list, each, self) { (list || []).forEach(each, self) }}\nvar modules = {}\n' + safe(modules)
        + '\nvar player\ntry {\n'
        + '  player = modules[\'' + PLAYER + '\'].play(JSON.parse(document.getElementById(\'run\').textContent))\n} catch (e) {\n'
        + '  document.getElementById(\'failed\').hidden = false\n  throw e\n}\n</script>\n</body>\n</html>\n'
}

/** Of one panel. */
export function makeShare(panel, messages, replay, ground) {
    var looks = null            // what has come of what is needed, by key; null while nothing is shared
    var missing = null          // keys that have not come
    var since = 0
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
        ask()
    }
    function ask() {
        var keys = Object.keys(missing)
        since = Date.now()
        if (keys.length) {
            panel.msg.send('getLooks', keys.slice(0, AT_ONCE))
            panel.timeout(function() {
                if (share.busy && Date.now() - since >= PATIENCE_MILLIS) {
                    fail('what things look like did not come')
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
        messages.say('error', 'the run could not be shared: ' + why)
    }
    /** What the service has sent, for this panel or another. */
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
            record: {times: record.times, robots: record.robots, objects: record.objects, robotPoses: record.robotPoses,
                objectPoses: record.objectPoses, speeds: record.speeds, lights: record.lights, brightness: record.brightness}}
        return Promise.all([textOf(source.src), bundle(PLAYER, [])]).then(function(parts) {
            var text = page(title, parts[0], parts[1], run)
            if (text.length > MOST) {
                throw new Error('the file would have ' + (text.length / 1e6).toFixed(1) + ' MB, legal: at most ' + MOST / 1e6
                    + ' MB; share a shorter record, or one of a world with fewer and simpler models')
            }
            saveText(title + '.html', text)
            messages.say('info', 'the run is saved as ' + title + '.html, ' + (text.length / 1e6).toFixed(1)
                + ' MB: it opens in any browser, without SEAR')
        })
    }
    /** A world without what this page has noted in it. */
    function plain(world) {
        return JSON.parse(JSON.stringify({time: 0, sensors: [], objects: world.objects, robots: world.robots},
            (key, value) => key === '$shape' || key === '$$hashKey' || key === 'path' ? undefined : value))
    }
    return share
}
