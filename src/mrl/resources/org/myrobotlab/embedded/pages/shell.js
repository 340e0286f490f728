// Page of the embedded MyRobotLab: a tab for each service, with its panel XGui, and the messages of all services.
(function() {
    var app = angular.module('mrlapp', ['mrlapp.mrl'])
    var providers = {}
    var MOST_STATUSES = 50

    app.config(['$controllerProvider', '$compileProvider', '$filterProvider', '$provide', function(controller, compile, filter, provide) {
        providers = {$controllerProvider: controller, $compileProvider: compile, $filterProvider: filter, $provide: provide}
    }])

    app.controller('ShellCtrl', ['$scope', '$location', '$document', 'mrl', 'panels', function($scope, $location, $document, mrl, panels) {
        var shell = this
        var FIRST = ['SEAR', 'LIDAR', 'GPS', 'Roomba', 'Python']
        var LAST = ['Runtime', 'WebGui']
        var REPEATED = 'could not invoke '
        var BARE = 'AnyGuiCtrl'
        var PORT = 'Serial'     // numerous and rarely viewed
        var faces = {}          // by type: whether it has its own panel
        shell.main = []         // services with a tab
        shell.ports = []        // services in the menu
        shell.bare = []
        shell.services = []
        shell.menu = false      // whether the menu is open
        shell.statuses = []
        shell.form = {name: '', type: ''}
        var wanted = null       // the tab that the user wants, shown whenever its service exists
        shell.shown = null
        // like MyRobotLab's layout: beside the list of services, at the same distance from the window's edges
        shell.beside = /[?&]layout=myrobotlab\b/.test(window.location.search)

        Object.defineProperty(shell, 'connected', {get: function() {
            return mrl.connected
        }})
        Object.defineProperty(shell, 'refused', {get: function() {
            return mrl.refused
        }})

        function order(service) {
            var at = FIRST.indexOf(service.simpleName)
            return at < 0 ? FIRST.length + 1 + LAST.indexOf(service.simpleName) : at
        }

        function choose() {
            var names = shell.main.concat(shell.bare, shell.ports).map(function(service) {
                return service.name
            })
            shell.shown = names.indexOf(wanted) < 0 ? names[0] : wanted
        }

        function isPort(service) {
            return service.simpleName === PORT
        }

        function isMain(service) {
            return !isPort(service) && faces[service.simpleName]
        }

        /** Services whose panel shows more than their state get a tab; the others are in the menu. */
        function sort() {
            shell.ports = shell.services.filter(isPort)
            shell.main = shell.services.filter(isMain)
            shell.bare = shell.services.filter(function(service) {
                return !isPort(service) && !isMain(service)
            })
            choose()
        }

        function lookForFace(service) {
            var type = service.simpleName
            if (!(type in faces)) {
                faces[type] = FIRST.indexOf(type) >= 0      // until known
                panels(type).then(function(panel) {
                    faces[type] = panel.controller !== BARE
                    sort()
                }, angular.noop)
            }
        }

        $scope.$on('mrl.services', function() {
            shell.services = mrl.getServices().slice().sort(function(a, b) {
                return order(a) - order(b) || (a.name < b.name ? -1 : 1)
            })
            shell.services.forEach(lookForFace)
            shell.services.forEach(function(service) {
                mrl.subscribe(service.name, 'publishStatus')
                mrl.subscribeToService(onStatus, service.name)
            })
            sort()
        })
        $scope.$on('$locationChangeSuccess', function() {
            wanted = $location.path().substring(1) || wanted
            choose()
        })
        $scope.$on('mrl.error', function(event, text) {
            add({level: 'error', name: 'page', detail: text})
        })

        function onStatus(message) {
            if (message.method === 'onStatus') {
                add(message.data[0])
                $scope.$applyAsync()
            }
        }

        var told = {}           // services that have reported why a call failed, before MyRobotLab's repetition
        function add(status) {
            var text = status.key || status.detail
            if (status.level === 'error') {
                var repeated = told[status.name] && text.indexOf(REPEATED) === 0
                told[status.name] = !repeated
                if (repeated) {
                    return
                }
            }
            shell.statuses.unshift({level: status.level, name: status.name, text: text, time: new Date()})
            shell.statuses.splice(MOST_STATUSES)
        }

        /** Whether to list a message here: not if the panel in front shows it itself. */
        shell.isNews = function(status) {
            var name = String(status.name).split('@')[0]
            return name !== shell.shown || !mrl.isShown(name, 'publishStatus')
        }
        shell.show = function(name) {
            wanted = name
            if (shell.menu) {
                closeMenu()
            }
            choose()
        }
        /** Whether the service in front is in the menu. */
        shell.inMenu = function() {
            return shell.bare.concat(shell.ports).some(function(service) {
                return service.name === shell.shown
            })
        }
        shell.start = function() {
            mrl.sendTo('runtime', 'start', shell.form.name, shell.form.type)
        }

        function closeMenu() {
            shell.menu = false
            document.getElementById('shell-more').focus()   // keeps the focus, which would disappear with the menu
            $scope.$applyAsync()
        }
        $document.on('mousedown', function(event) {
            if (shell.menu && !angular.element(event.target).closest('.shell-menu').length) {
                shell.menu = false
                $scope.$applyAsync()
            }
        })
        $document.on('keydown', function(event) {
            if (shell.menu && event.key === 'Escape') {
                closeMenu()
            }
        })
    }])

    // Registers a module loaded after the application's start: passes its declarations to the providers.
    function register(module) {
        module._invokeQueue.forEach(function(call) {
            providers[call[0]][call[1]].apply(providers[call[0]], call[2])
        })
        module._invokeQueue = []
    }

    app.factory('panels', ['$q', '$http', function($q, $http) {
        var loaded = {}

        function script(url) {
            var done = $q.defer()
            var element = document.createElement('script')
            element.src = url
            element.onload = done.resolve
            element.onerror = done.reject
            document.head.appendChild(element)
            return done.promise
        }

        function load(type) {
            return $http.get('service/views/' + type + 'Gui.html').then(function(view) {
                if (!view.data) {
                    return $q.reject('no panel for ' + type)
                }
                return script('service/js/' + type + 'Gui.js').then(function() {
                    register(angular.module('mrlapp.service.' + type + 'Gui'))
                    return {controller: type + 'GuiCtrl', view: view.data}
                })
            })
        }

        /** Returns the panel of a type, or the general one if it has none. */
        return function(type) {
            loaded[type] = loaded[type] || load(type).catch(function() {
                return type === 'Any' ? $q.reject() : load('Any')
            })
            return loaded[type]
        }
    }])

    /**
     * Adds the members that MyRobotLab puts on a panel's scope after its controller; they overwrite the panel's own of
     * the same name.
     */
    function addMembers(scope, msg) {
        scope.parentPanel = {name: msg.name}
        scope.peer = null
        scope.showPeers = false
        scope.servicedatajson = ''
        ;['save', 'saveDefault', 'apply', 'startPeer', 'releasePeer', 'updateServiceData'].forEach(function(method) {
            scope[method] = function() {
                msg.send.apply(null, [method].concat(Array.prototype.slice.call(arguments)))
            }
        })
        scope.release = function() {
            msg.sendTo('runtime', 'release', msg.name)
        }
        scope.toggleVirtual = function() {
            msg.send('setVirtual', !scope.service.isVirtual)
        }
    }

    app.directive('mrlPanel', ['$compile', '$controller', '$templateCache', 'mrl', 'panels', function($compile, $controller, $templateCache, mrl, panels) {
        return {
            restrict: 'E',
            scope: true,
            link: function(scope, element, attributes) {
                var name = attributes.name
                var msg = mrl.createMsgInterface(name)
                var controller = null
                scope.name = name
                scope.msg = msg
                scope.service = mrl.getService(name)
                panels(attributes.type).then(function(panel) {
                    var make = $controller(panel.controller, {$scope: scope}, true)
                    make.instance.msg = msg
                    controller = make()
                    addMembers(scope, msg)
                    element.html($templateCache.get('tab-header.html') + panel.view)
                    $compile(element.contents())(scope)
                })
                scope.$on('$destroy', function() {
                    if (controller) {
                        msg.unsubscribe(controller)
                    }
                })
            }
        }
    }])
})()
