// SPDX-License-Identifier: Apache-2.0
// Opening, saving, uploading and downloading projects in the SEAR panel.
import {makeEvent} from '../shared/event.js'
import {recallJson, remember} from '../shared/page.js'
import * as words from '../shared/words.js'

var CHUNK = 256 * 1024      // characters; MyRobotLab accepts messages up to 1 MiB
var RECENT = 'sear.recentProjects'
var NEW = 'project.sear'
var MOST_RECENT = 8

/** Makes the project controls of one panel. */
export function makeProject(panel, messages, problems, view) {
    var msg = panel.msg
    var given = {}              // scripts that this page added to MyRobotLab's Python tab
    var asked = {}              // paths that this page asked to save and open
    var project = {
        path: NEW,
        example: '',
        examples: [],
        script: '',
        scripts: [],            // names of the example scripts
        template: 'userCode.py',
        folder: 'SEARproject',  // target folder of the template
        question: null,         // question before overwriting a file: path, and free, an unused name
        transfer: null,
        left: makeEvent(),      // the user opens another project
        recent: recallJson(RECENT) || []
    }

    function addRecent(path) {
        project.recent = [path].concat(project.recent.filter(other => other !== path)).slice(0, MOST_RECENT)
        remember(RECENT, JSON.stringify(project.recent), messages, 'recent projects')
    }
    project.open = function(path) {
        problems.forget()
        project.left.tell()
        project.path = path
        addRecent(path)
        asked.load = path
        msg.send('loadProject', path)
    }
    /** An opened example is saved beside the example, not over it. */
    function onLoaded() {
        view.fit()
        messages.say('info', 'opened ' + (asked.load || 'by another page'))
        if (asked.load && project.examples.indexOf(asked.load) >= 0) {
            project.path = words.fileName(asked.load)
        }
        asked.load = null
    }
    project.startAnew = function() {
        asked.anew = true
        project.left.tell()
        msg.send('newProject')
    }

    var written = {}            // paths that this page has saved to and overwrites without asking
    project.save = function() {
        project.saveTo(project.path, Boolean(written[project.path]))
    }
    project.saveTo = function(path, overwrite) {
        project.question = null
        if (!path || !path.trim()) {
            messages.say('error', 'enter a name in the field Project before you save, for example ' + NEW)
            return
        }
        asked.save = path
        msg.send('saveProjectAs', path, overwrite)
    }
    project.cancel = function() {
        project.question = null
    }
    function onSaved(answer) {
        var mine = asked.save === answer.asked
        if (answer.saved) {
            messages.say('info', mine ? 'saved ' + answer.path : 'saved by another page')
        }
        if (mine && answer.saved) {
            written[answer.path] = true
            project.path = answer.path
            addRecent(answer.path)
        } else if (mine) {
            project.question = answer
        }
        asked.save = mine ? null : asked.save
    }
    project.named = function(script) {
        return script.replace(/\.py$/, '').replace(/_/g, ' ')
    }
    project.runScript = function() {
        var script = project.script
        view.fit()
        messages.say('info', 'running ' + script + '. You can change it in the Python tab and run it again')
        project.left.tell()
        msg.send('runExampleScript', script)
        asked.script = script
        msg.send('getExampleScript', script)
    }
    function onScript(code) {
        var script = asked.script
        asked.script = null
        if (!script) {
            return              // run by another page
        }
        var opened = /\bloadProject\(\s*["']([^"']+)/.exec(code)
        if (opened) {
            project.path = words.fileName(opened[1])
            addRecent(opened[1])
        }
        show({file: script, code: code})
    }
    /** Adds a script to the Python tab once, which keeps the user's changes. */
    function show(script) {
        var told = panel.scope.$root.$broadcast('python.show', script)
        if (!told.defaultPrevented && !given[script.file]) {
            msg.sendTo('python', 'addScript', script.file, script.code)
        }
        given[script.file] = true
    }
    project.copyTemplate = function() {
        msg.send('copyTemplate', project.template, project.folder)
    }

    project.upload = function(file) {
        if (!file) {
            return
        }
        var reader = new FileReader()
        reader.onload = function() {
            var text = reader.result.substring(reader.result.indexOf(',') + 1)
            var parts = Math.max(1, Math.ceil(text.length / CHUNK))
            problems.forget()
            project.left.tell()
            for (var i = 0; i < parts; i++) {
                msg.send('uploadProject', file.name, i, parts, text.substring(i * CHUNK, (i + 1) * CHUNK))
            }
            project.transfer = 'loading ' + file.name
            asked.upload = file.name
            panel.scope.$applyAsync()
        }
        reader.onerror = function() {
            messages.say('error', file.name + ' can\'t be read: ' + reader.error.message)
            panel.scope.$applyAsync()
        }
        reader.readAsDataURL(file)
    }

    var parts = null            // parts of the bundle that this page downloads
    project.download = function() {
        parts = []
        project.transfer = 'saving'
        msg.send('getBundle', 0)
    }
    function onBundle(part) {
        if (!parts || part.index !== parts.length) {
            return              // downloaded by another page
        }
        parts.push(part.data)
        if (parts.length < part.count) {
            project.transfer = 'saving, part ' + parts.length + ' of ' + part.count
            msg.send('getBundle', parts.length)
            return
        }
        words.saveFile(words.fileName(project.path).replace(/(\.sear)?$/, '.sear'), parts)
        parts = null
        project.transfer = null
    }

    /** Adds the listeners once the elements exist. */
    project.listen = function() {
        var drop = panel.element('workspace')
        drop.addEventListener('dragover', function(event) {
            event.preventDefault()
        })
        drop.addEventListener('drop', function(event) {
            event.preventDefault()
            project.upload(event.dataTransfer.files[0])
        })
        drop.addEventListener('change', function(event) {      // the file field is created dynamically
            if (event.target.classList.contains('sear-file')) {
                project.upload(event.target.files[0])
                event.target.value = ''     // allows choosing the same file again
            }
        })
    }

    /** Forgets pending requests after a failed call. */
    project.fail = function() {
        project.transfer = null
        asked = {}
    }

    project.handlers = {
        onBundle: onBundle,
        onExamples: function(paths) {
            project.examples = paths || []
        },
        onExampleScripts: function(names) {
            project.scripts = names || []
            project.script = project.script || project.scripts[0]
        },
        onExampleScript: onScript,
        onUploaded: function(text) {
            view.fit()
            project.transfer = null
            if (asked.upload) {
                project.path = asked.upload
            }
            asked.upload = null
            messages.say('info', text)
        },
        onSaveProject: function() {
            messages.say('info', 'saved by another page')
        },
        onSaveProjectAs: onSaved,
        onLoadProject: onLoaded,
        onNewProject: function(backup) {
            view.fit()
            if (asked.anew) {
                project.path = NEW
            }
            asked.anew = false
            messages.say('info', 'new project' + (backup ? '; the previous one is stored in ' + backup : ''))
        },
        onCopyTemplate: function(path) {
            messages.say('info', 'copied to ' + path)
        }
    }
    return project
}
