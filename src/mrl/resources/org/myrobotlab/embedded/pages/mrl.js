// The service "mrl" for panels: messages to and from MyRobotLab's services. docs/panels.md describes it.
angular.module('mrlapp.mrl', []).service('mrl', ['$rootScope', '$q', '$timeout', function($rootScope, $q, $timeout) {
    var self = this
    var RETRY = 1000
    var OWN = ['send', 'sendTo', 'sendBlocking', 'subscribe', 'unsubscribe', 'getName', 'name']
    var socket = null
    var nextId = 1
    var waiting = {}        // id of a call -> promise of its answer
    var topics = {}         // service -> topic -> true
    var shown = {}          // service and topic subscribed to by a service's own panel
    var callbacks = {}      // service -> functions that receive its messages
    var states = {}         // service -> its last state
    var methods = {}        // service -> names of its methods
    var interfaces = {}     // service -> msg
    var missed = false      // whether states may have changed without a connection
    this.connected = false
    this.refused = false    // whether the server asks for a token and has not received a valid one
    this.services = []

    function connect() {
        var opened = false
        socket = new WebSocket((location.protocol === 'https:' ? 'wss://' : 'ws://') + location.host + '/api/messages')
        socket.onopen = function() {
            opened = true
            self.connected = true
            self.refused = false
            missed = true
            Object.keys(topics).forEach(function(name) {
                Object.keys(topics[name]).forEach(function(topic) {
                    transmit({subscribe: name, topic: topic})
                })
            })
            $rootScope.$broadcast('mrl.connected')
            $rootScope.$applyAsync()
        }
        socket.onclose = function() {
            self.connected = false
            Object.keys(waiting).forEach(function(id) {
                waiting[id].reject('the connection was lost')
            })
            waiting = {}
            $rootScope.$applyAsync()
            setTimeout(connect, RETRY)
            if (!opened) {
                askWhy()
            }
        }
        socket.onmessage = function(event) {
            receive(JSON.parse(event.data))
        }
    }

    /** A web socket does not report why it failed to open; a request does. */
    function askWhy() {
        fetch('api/service').then(function(answer) {
            self.refused = answer.status === 401
            $rootScope.$applyAsync()
        }, angular.noop)
    }

    function transmit(message) {
        if (self.connected) {
            socket.send(JSON.stringify(message))
        }
    }

    function receive(message) {
        if (message.services) {
            setServices(message.services)
        } else if (message.method) {
            deliver(message)
        } else if (message.id !== null && waiting[message.id]) {
            var answer = waiting[message.id]
            delete waiting[message.id]
            if (message.error === undefined) {
                answer.resolve(message.answer)
            } else {
                answer.reject(message.error)
            }
            $rootScope.$applyAsync()
        } else if (message.error) {
            $rootScope.$broadcast('mrl.error', message.error)
            $rootScope.$applyAsync()
        }
    }

    function setServices(services) {
        var before = self.services.map(key)
        services.forEach(function(service) {
            methods[service.name] = service.methods
            addMethods(service.name)
            states[service.name] = states[service.name] || {name: service.name, simpleName: service.simpleName}
            if ((missed || before.indexOf(key(service)) < 0) && callbacks[service.name]) {
                self.sendTo(service.name, 'broadcastState')
            }
        })
        missed = false
        self.services = services
        $rootScope.$broadcast('mrl.services')
        $rootScope.$applyAsync()
    }

    function key(service) {
        return service.name + ' ' + service.typeKey + ' ' + service.running
    }

    function deliver(message) {
        if (message.method === 'onState') {
            states[message.name] = message.data[0]
        }
        ;(callbacks[message.name] || []).slice().forEach(function(callback) {
            try {
                callback(message)
            } catch (error) {
                console.error('panel of ' + message.name + ', ' + message.method, error)
            }
        })
    }

    /** Calls a service's method without waiting for an answer. */
    this.sendTo = function(name, method) {
        transmit({name: name, method: method, data: Array.prototype.slice.call(arguments, 2)})
    }

    /** Calls a service's method. @return a promise of its answer */
    this.sendBlocking = function(name, method) {
        var answer = $q.defer()
        var id = nextId++
        if (!self.connected) {
            answer.reject('not connected')
            return answer.promise
        }
        waiting[id] = answer
        transmit({id: id, name: name, method: method, data: Array.prototype.slice.call(arguments, 2)})
        return answer.promise
    }

    /** Subscribes to a topic: a service's publishX arrives as onX. */
    this.subscribe = function(name, topic) {
        topics[name] = topics[name] || {}
        topics[name][topic] = true
        transmit({subscribe: name, topic: topic})
    }

    this.unsubscribe = function(name, topic) {
        if (topics[name]) {
            delete topics[name][topic]
        }
        transmit({unsubscribe: name, topic: topic})
    }

    /** Whether a service's own panel has subscribed to a topic. */
    this.isShown = function(name, topic) {
        return Boolean(shown[name + ' ' + topic])
    }

    /** Calls a function with all messages of a service. */
    this.subscribeToService = function(callback, name) {
        callbacks[name] = callbacks[name] || []
        if (callbacks[name].indexOf(callback) < 0) {
            callbacks[name].push(callback)
        }
    }

    this.unsubscribeFromService = function(callback, name) {
        callbacks[name] = (callbacks[name] || []).filter(function(one) {
            return one !== callback
        })
    }

    /** Returns the last state of a service. */
    this.getService = function(name) {
        return states[name]
    }

    this.getServices = function() {
        return self.services
    }

    /**
     * Returns the msg of a panel: send, subscribe and so on for one service, and a function for each of its methods.
     */
    this.createMsgInterface = function(name) {
        interfaces[name] = interfaces[name] || makeInterface(name)
        addMethods(name)
        return interfaces[name]
    }

    function makeInterface(name) {
        function to(call) {
            return function() {
                return call.apply(self, [name].concat(Array.prototype.slice.call(arguments)))
            }
        }
        return {
            name: name,
            getName: function() {
                return name
            },
            send: to(self.sendTo),
            sendBlocking: to(self.sendBlocking),
            sendTo: self.sendTo,
            subscribe: function(what) {
                if (typeof what === 'string') {
                    shown[name + ' ' + what] = true
                    self.subscribe(name, what)
                } else {
                    self.subscribeToService(what.onMsg, name)
                    self.subscribe(name, 'publishState')
                    self.sendTo(name, 'broadcastState')
                }
            },
            unsubscribe: function(what) {
                if (typeof what === 'string') {
                    self.unsubscribe(name, what)
                } else {
                    self.unsubscribeFromService(what.onMsg, name)
                }
            }
        }
    }

    function addMethods(name) {
        var target = interfaces[name]
        if (target) {
            (methods[name] || []).forEach(function(method) {
                if (OWN.indexOf(method) < 0) {
                    target[method] = function() {
                        target.send.apply(null, [method].concat(Array.prototype.slice.call(arguments)))
                    }
                }
            })
        }
    }

    // A browser may cache a left page with its connection for the back button. The page then connects again.
    window.addEventListener('pagehide', function() {
        socket.close()
    })
    connect()
}])
