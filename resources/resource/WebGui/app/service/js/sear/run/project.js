// SPDX-License-Identifier: Apache-2.0
// Opening, saving, uploading and downloading projects in the SEAR panel.
import {Listeners} from '../shared/listeners.js'
import {recallJson, remember} from '../shared/page.js'
import * as words from '../shared/words.js'

const CHUNK = 256 * 1024      // characters; MyRobotLab accepts messages up to 1 MiB
const RECENT = 'sear.recentProjects'
const NEW = 'project.sear'
const ADDED = /\.urdf$/i       // files that are added to the project; others replace it
const MOST_RECENT = 8

/** The project controls of one panel. */
export class Project {
    constructor(panel, messages, world, problems, view, shelf) {
        this.panel = panel
        this.messages = messages
        this.world = world
        this.problems = problems
        this.view = view
        this.shelf = shelf
        this.msg = panel.msg
        this.given = {}         // scripts that this page added to MyRobotLab's Python tab
        this.asked = {}         // paths that this page asked to save and open
        this.path = NEW
        this.known = null       // the service's path of the project
        this.other = ''         // path of a file to open
        this.examples = []
        this.kept = null        // the replaced project that the page offers to bring back: path, words
        this.lastKept = ''
        this.leaving = false    // whether this page asked for the replacement
        this.script = ''
        this.scripts = []       // names of the example scripts
        this.template = 'userCode.py'
        this.folder = 'SEARproject' // target folder of the template
        this.question = null    // question before overwriting a file: path, and free, an unused name
        this.transfer = null
        this.left = new Listeners() // the user opens another project
        this.recent = recallJson(RECENT) || []

        this.parts = null       // parts of the bundle that this page downloads

        this.handlers = {
            onBundle: part => this.onBundle(part),
            onExamples: paths => {
                this.examples = paths || []
            },
            onExampleScripts: names => {
                this.scripts = names || []
                this.script = this.script || this.scripts[0]
            },
            onExampleScript: code => this.onScript(code),
            onUploaded: text => {
                view.fit()
                this.transfer = null
                messages.say('info', text)
            },
            onSaveProject: () => {
                messages.say('info', 'saved by another page')
            },
            onSaveProjectAs: answer => this.onSaved(answer),
            onLoadProject: () => this.onLoaded(),
            onNewProject: () => {
                view.fit()
                world.look()
                messages.say('info', 'new project')
            },
            onKept: kept => this.onKept(kept),
            onCopyTemplate: path => {
                messages.say('info', 'copied to ' + path)
            }
        }
    }

    addRecent(path) {
        this.recent = [path].concat(this.recent.filter(other => other !== path)).slice(0, MOST_RECENT)
        remember(RECENT, JSON.stringify(this.recent), this.messages, 'recent projects')
    }

    /** Opens a project. @param name for messages, if the path says nothing */
    open(path, name) {
        this.problems.forget()
        this.leave()
        if (!name) {
            this.addRecent(path)
        }
        this.asked.load = name || path
        this.msg.send('loadProject', path)
    }

    /** Before another project opens. */
    leave() {
        this.kept = null
        this.known = null
        this.leaving = true
        this.left.tell()
    }

    onLoaded() {
        this.view.fit()
        this.world.look()
        this.messages.say('info', 'opened ' + (this.asked.load || 'by another page'))
        this.asked.load = null
    }

    /** Offers to bring a replaced project back. A script that runs again replaces its own world without an offer. */
    onKept(kept) {
        this.shelf.look()
        this.world.look()
        const again = this.lastKept === kept.words && !this.leaving
        this.lastKept = kept.words
        this.leaving = false
        if (!again) {
            this.kept = kept
            this.messages.say('info', 'your world is kept: ' + kept.words)
        }
    }

    bringBack() {
        this.open(this.kept.path, this.kept.words)
    }

    hideKept() {
        this.kept = null
    }

    /** Takes the service's path of the project, for every page and after a reload. */
    follow() {
        const path = this.panel.scope.service.project
        if (path && path !== this.known) {
            this.known = path
            this.path = path
        }
    }

    startAnew() {
        this.leave()
        this.msg.send('newProject')
    }

    save() {
        const service = this.panel.scope.service
        this.saveTo(this.path, Boolean(service.saved) && this.path === service.project)
    }

    saveTo(path, overwrite) {
        this.question = null
        if (!path || !path.trim()) {
            this.messages.say('error', 'enter a name in the field Project before you save, for example ' + NEW)
            return
        }
        this.asked.save = path
        this.msg.send('saveProjectAs', path, overwrite)
    }

    cancel() {
        this.question = null
    }

    onSaved(answer) {
        const mine = this.asked.save === answer.asked
        if (answer.saved) {
            this.messages.say('info', mine ? 'saved ' + answer.path : 'saved by another page')
            this.shelf.look()
        }
        if (mine && answer.saved) {
            this.path = answer.path
            this.addRecent(answer.path)
        } else if (mine) {
            this.question = answer
        }
        this.asked.save = mine ? null : this.asked.save
    }

    named(script) {
        return script.replace(/\.py$/, '').replace(/_/g, ' ')
    }

    runScript() {
        const script = this.script
        this.view.fit()
        this.messages.say('info', 'running ' + script + '. You can change it in the Python tab and run it again')
        this.leave()
        this.msg.send('runExampleScript', script)
        this.asked.script = script
        this.msg.send('getExampleScript', script)
    }

    onScript(code) {
        const script = this.asked.script
        this.asked.script = null
        if (!script) {
            return              // run by another page
        }
        this.show({file: script, code})
    }

    /** Adds a script to the Python tab once, which keeps the user's changes. */
    show(script) {
        const told = this.panel.scope.$root.$broadcast('python.show', script)
        if (!told.defaultPrevented && !this.given[script.file]) {
            this.msg.sendTo('python', 'addScript', script.file, script.code)
        }
        this.given[script.file] = true
    }

    copyTemplate() {
        this.msg.send('copyTemplate', this.template, this.folder)
    }

    upload(file) {
        if (!file) {
            return
        }
        const reader = new FileReader()
        reader.onload = () => {
            const text = reader.result.substring(reader.result.indexOf(',') + 1)
            const parts = Math.max(1, Math.ceil(text.length / CHUNK))
            this.problems.forget()
            if (!ADDED.test(file.name)) {
                this.leave()
            }
            for (let i = 0; i < parts; i++) {
                this.msg.send('uploadProject', file.name, i, parts, text.substring(i * CHUNK, (i + 1) * CHUNK))
            }
            this.transfer = 'loading ' + file.name
            this.panel.scope.$applyAsync()
        }
        reader.onerror = () => {
            this.messages.say('error', file.name + ' can\'t be read: ' + reader.error.message)
            this.panel.scope.$applyAsync()
        }
        reader.readAsDataURL(file)
    }

    download() {
        this.parts = []
        this.transfer = 'saving'
        this.msg.send('getBundle', 0)
    }

    onBundle(part) {
        if (!this.parts || part.index !== this.parts.length) {
            return              // downloaded by another page
        }
        this.parts.push(part.data)
        if (this.parts.length < part.count) {
            this.transfer = 'saving, part ' + this.parts.length + ' of ' + part.count
            this.msg.send('getBundle', this.parts.length)
            return
        }
        words.saveFile(words.fileName(this.path).replace(/(\.sear)?$/, '.sear'), this.parts)
        this.parts = null
        this.transfer = null
    }

    /** Adds the listeners once the elements exist. */
    listen() {
        const drop = this.panel.element('workspace')
        drop.addEventListener('dragover', event => {
            event.preventDefault()
        })
        drop.addEventListener('drop', event => {
            event.preventDefault()
            this.upload(event.dataTransfer.files[0])
        })
        drop.addEventListener('change', event => {      // the file field is created dynamically
            if (event.target.classList.contains('sear-file')) {
                this.upload(event.target.files[0])
                event.target.value = ''     // allows choosing the same file again
            }
        })
    }

    /** Forgets pending requests after a failed call. */
    fail() {
        this.transfer = null
        this.asked = {}
    }
}
