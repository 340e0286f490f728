// Page of the embedded MyRobotLab: a tab for each service, with its panel XGui, and the messages of all services.
{
    const app = angular.module('mrlapp', ['mrlapp.mrl'])
    const MOST_STATUSES = 50
    const FIRST = ['SEAR', 'LIDAR', 'GPS', 'Roomba', 'Python']
    const LAST = ['Runtime', 'WebGui']
    const REPEATED = 'could not invoke '
    const BARE = 'AnyGuiCtrl'
    const PORT = 'Serial'    // numerous and rarely viewed
    let providers = {}

    app.config(['$controllerProvider', '$compileProvider', '$filterProvider', '$provide',
        (controller, compile, filter, provide) => {
        providers = {$controllerProvider: controller, $compileProvider: compile, $filterProvider: filter,
            $provide: provide}
    }])

    /** The page: which services have a tab, which one is in front, and the messages of all. */
    class Shell {
        constructor($scope, $location, $document, mrl, panels) {
            this.$scope = $scope
            this.mrl = mrl
            this.panels = panels
            this.faces = {}         // by type: whether it has its own panel
            this.main = []         // services with a tab
            this.ports = []        // services in the menu
            this.bare = []
            this.services = []
            this.menu = false      // whether the menu is open
            this.statuses = []
            this.form = {name: '', type: ''}
            this.wanted = null      // the tab that the user wants, shown whenever its service exists
            this.shown = null
            // like MyRobotLab's layout: beside the list of services, at the same distance from the window's edges
            this.beside = /[?&]layout=myrobotlab\b/.test(window.location.search)

            /** Whether to list a message here: not if the panel in front shows it itself. */
            this.isNews = status => {
                const name = String(status.name).split('@')[0]
                return name !== this.shown || !mrl.isShown(name, 'publishStatus')
            }
            const onStatus = message => this.onStatus(message)
            $scope.$on('mrl.services', () => {
                this.services = mrl.getServices().slice()
                    .sort((a, b) => this.order(a) - this.order(b) || (a.name < b.name ? -1 : 1))
                this.services.forEach(service => this.lookForFace(service))
                this.services.forEach(service => {
                    mrl.subscribe(service.name, 'publishStatus')
                    mrl.subscribeToService(onStatus, service.name)
                })
                this.sort()
            })
            $scope.$on('$locationChangeSuccess', () => {
                this.wanted = $location.path().substring(1) || this.wanted
                this.choose()
            })
            $scope.$on('mrl.error', (event, text) => {
                this.add({level: 'error', name: 'page', detail: text})
            })

            this.told = {}          // services that have reported why a call failed, before MyRobotLab's repetition
            $document.on('mousedown', event => {
                if (this.menu && !angular.element(event.target).closest('.shell-menu').length) {
                    this.menu = false
                    $scope.$applyAsync()
                }
            })
            $document.on('keydown', event => {
                if (this.menu && event.key === 'Escape') {
                    this.closeMenu()
                }
            })
        }

        get connected() {
            return this.mrl.connected
        }

        get refused() {
            return this.mrl.refused
        }

        /** Returns the wanted service as long as it does not exist, for example before a script starts it. */
        get missing() {
            const isThere = this.services.some(service => service.name === this.wanted)
            return this.connected && this.services.length && this.wanted && !isThere ? this.wanted : ''
        }

        order(service) {
            const at = FIRST.indexOf(service.simpleName)
            return at < 0 ? FIRST.length + 1 + LAST.indexOf(service.simpleName) : at
        }

        choose() {
            const names = this.main.concat(this.bare, this.ports).map(service => service.name)
            this.shown = names.indexOf(this.wanted) < 0 ? names[0] : this.wanted
        }

        isPort(service) {
            return service.simpleName === PORT
        }

        isMain(service) {
            return !this.isPort(service) && this.faces[service.simpleName]
        }

        /** Services whose panel shows more than their state get a tab; the others are in the menu. */
        sort() {
            this.ports = this.services.filter(service => this.isPort(service))
            this.main = this.services.filter(service => this.isMain(service))
            this.bare = this.services.filter(service => !this.isPort(service) && !this.isMain(service))
            this.choose()
        }

        lookForFace(service) {
            const type = service.simpleName
            if (!(type in this.faces)) {
                this.faces[type] = FIRST.indexOf(type) >= 0      // until known
                this.panels(type).then(panel => {
                    this.faces[type] = panel.controller !== BARE
                    this.sort()
                }, angular.noop)
            }
        }

        onStatus(message) {
            if (message.method === 'onStatus') {
                this.add(message.data[0])
                this.$scope.$applyAsync()
            }
        }

        add(status) {
            const text = status.key || status.detail
            if (status.level === 'error') {
                const repeated = this.told[status.name] && text.indexOf(REPEATED) === 0
                this.told[status.name] = !repeated
                if (repeated) {
                    return
                }
            }
            this.statuses.unshift({level: status.level, name: status.name, text, time: new Date()})
            this.statuses.splice(MOST_STATUSES)
        }

        show(name) {
            this.wanted = name
            if (this.menu) {
                this.closeMenu()
            }
            this.choose()
        }

        /** Whether the service in front is in the menu. */
        inMenu() {
            return this.bare.concat(this.ports).some(service => service.name === this.shown)
        }

        start() {
            this.mrl.sendTo('runtime', 'start', this.form.name, this.form.type)
        }

        closeMenu() {
            this.menu = false
            document.getElementById('shell-more').focus()   // keeps the focus, which would disappear with the menu
            this.$scope.$applyAsync()
        }
    }

    app.controller('ShellCtrl', ['$scope', '$location', '$document', 'mrl', 'panels', Shell])

    // Registers a module loaded after the application's start: passes its declarations to the providers.
    const register = module => {
        module._invokeQueue.forEach(([provider, method, call]) => providers[provider][method](...call))
        module._invokeQueue = []
    }

    app.factory('panels', ['$q', '$http', function($q, $http) {
        const loaded = {}

        function script(url) {
            const done = $q.defer()
            const element = document.createElement('script')
            element.src = url
            element.onload = done.resolve
            element.onerror = done.reject
            document.head.appendChild(element)
            return done.promise
        }

        function load(type) {
            return $http.get('service/views/' + type + 'Gui.html').then(view => {
                if (!view.data) {
                    return $q.reject('no panel for ' + type)
                }
                return script('service/js/' + type + 'Gui.js').then(() => {
                    register(angular.module('mrlapp.service.' + type + 'Gui'))
                    return {controller: type + 'GuiCtrl', view: view.data}
                })
            })
        }

        /** Returns the panel of a type, or the general one if it has none. */
        return type => {
            loaded[type] = loaded[type] || load(type).catch(() => type === 'Any' ? $q.reject() : load('Any'))
            return loaded[type]
        }
    }])

    /**
     * Adds the members that MyRobotLab puts on a panel's scope after its controller; they overwrite the panel's own of
     * the same name.
     */
    const addMembers = (scope, msg) => {
        scope.parentPanel = {name: msg.name}
        scope.peer = null
        scope.showPeers = false
        scope.servicedatajson = ''
        ;['save', 'saveDefault', 'apply', 'startPeer', 'releasePeer', 'updateServiceData'].forEach(method => {
            scope[method] = (...data) => msg.send(method, ...data)
        })
        scope.release = () => msg.sendTo('runtime', 'release', msg.name)
        scope.toggleVirtual = () => msg.send('setVirtual', !scope.service.isVirtual)
    }

    const needed = ['$compile', '$controller', '$templateCache', 'mrl', 'panels']
    app.directive('mrlPanel', needed.concat(($compile, $controller, $templateCache, mrl, panels) => ({
        restrict: 'E',
        scope: true,
        link(scope, element, attributes) {
            const name = attributes.name
            const msg = mrl.createMsgInterface(name)
            let controller = null
            scope.name = name
            scope.msg = msg
            scope.service = mrl.getService(name)
            panels(attributes.type).then(panel => {
                const make = $controller(panel.controller, {$scope: scope}, true)
                make.instance.msg = msg
                controller = make()
                addMembers(scope, msg)
                element.html($templateCache.get('tab-header.html') + panel.view)
                $compile(element.contents())(scope)
            })
            scope.$on('$destroy', () => {
                if (controller) {
                    msg.unsubscribe(controller)
                }
            })
        }
    })))
}
