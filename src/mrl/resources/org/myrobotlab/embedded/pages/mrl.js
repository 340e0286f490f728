// The service "mrl" for panels: messages to and from MyRobotLab's services. docs/panels.md describes it.
{
    const RETRY = 1000
    const OWN = ['send', 'sendTo', 'sendBlocking', 'subscribe', 'unsubscribe', 'getName', 'name']

    const key = service => service.name + ' ' + service.typeKey + ' ' + service.running

    class Mrl {
        constructor($rootScope, $q) {
            this.$rootScope = $rootScope
            this.$q = $q
            this.socket = null
            this.nextId = 1
            this.waiting = {}   // id of a call -> promise of its answer
            this.topics = {}    // service -> topic -> true
            this.shown = {}     // service and topic subscribed to by a service's own panel
            this.callbacks = {} // service -> functions that receive its messages
            this.states = {}    // service -> its last state
            this.methods = {}   // service -> names of its methods
            this.interfaces = {} // service -> msg
            this.missed = false // whether states may have changed without a connection
            this.connected = false
            this.refused = false    // whether the server asks for a token and has not received a valid one
            this.services = []

            // A browser may cache a left page with its connection for the back button. The page then connects again.
            window.addEventListener('pagehide', () => {
                this.socket.close()
            })
            this.connect()
        }

        connect() {
            let opened = false
            this.socket = new WebSocket((location.protocol === 'https:' ? 'wss://' : 'ws://') + location.host
                + '/api/messages')
            this.socket.onopen = () => {
                opened = true
                this.connected = true
                this.refused = false
                this.missed = true
                Object.keys(this.topics).forEach(name => {
                    Object.keys(this.topics[name]).forEach(topic => {
                        this.transmit({subscribe: name, topic})
                    })
                })
                this.$rootScope.$broadcast('mrl.connected')
                this.$rootScope.$applyAsync()
            }
            this.socket.onclose = () => {
                this.connected = false
                Object.keys(this.waiting).forEach(id => {
                    this.waiting[id].reject('the connection was lost')
                })
                this.waiting = {}
                this.$rootScope.$applyAsync()
                setTimeout(() => this.connect(), RETRY)
                if (!opened) {
                    this.askWhy()
                }
            }
            this.socket.onmessage = event => {
                this.receive(JSON.parse(event.data))
            }
        }

        /** A web socket does not report why it failed to open; a request does. */
        askWhy() {
            fetch('api/service').then(answer => {
                this.refused = answer.status === 401
                this.$rootScope.$applyAsync()
            }, angular.noop)
        }

        transmit(message) {
            if (this.connected) {
                this.socket.send(JSON.stringify(message))
            }
        }

        receive(message) {
            if (message.services) {
                this.setServices(message.services)
            } else if (message.method) {
                this.deliver(message)
            } else if (message.id !== null && this.waiting[message.id]) {
                const answer = this.waiting[message.id]
                delete this.waiting[message.id]
                if (message.error === undefined) {
                    answer.resolve(message.answer)
                } else {
                    answer.reject(message.error)
                }
                this.$rootScope.$applyAsync()
            } else if (message.error) {
                this.$rootScope.$broadcast('mrl.error', message.error)
                this.$rootScope.$applyAsync()
            }
        }

        setServices(services) {
            const before = this.services.map(key)
            services.forEach(service => {
                this.methods[service.name] = service.methods
                this.addMethods(service.name)
                this.states[service.name] = this.states[service.name]
                || {name: service.name, simpleName: service.simpleName}
                if ((this.missed || before.indexOf(key(service)) < 0) && this.callbacks[service.name]) {
                    this.sendTo(service.name, 'broadcastState')
                }
            })
            this.missed = false
            this.services = services
            this.$rootScope.$broadcast('mrl.services')
            this.$rootScope.$applyAsync()
        }

        deliver(message) {
            if (message.method === 'onState') {
                this.states[message.name] = message.data[0]
            }
            ;(this.callbacks[message.name] || []).slice().forEach(callback => {
                try {
                    callback(message)
                } catch (error) {
                    console.error('panel of ' + message.name + ', ' + message.method, error)
                }
            })
        }

        /** Calls a service's method without waiting for an answer. */
        sendTo(name, method, ...data) {
            this.transmit({name, method, data})
        }

        /** Calls a service's method. @return a promise of its answer */
        sendBlocking(name, method, ...data) {
            const answer = this.$q.defer()
            const id = this.nextId++
            if (!this.connected) {
                answer.reject('not connected')
                return answer.promise
            }
            this.waiting[id] = answer
            this.transmit({id, name, method, data})
            return answer.promise
        }

        /** Subscribes to a topic: a service's publishX arrives as onX. */
        subscribe(name, topic) {
            this.topics[name] = this.topics[name] || {}
            this.topics[name][topic] = true
            this.transmit({subscribe: name, topic})
        }

        unsubscribe(name, topic) {
            if (this.topics[name]) {
                delete this.topics[name][topic]
            }
            this.transmit({unsubscribe: name, topic})
        }

        /** Whether a service's own panel has subscribed to a topic. */
        isShown(name, topic) {
            return Boolean(this.shown[name + ' ' + topic])
        }

        /** Calls a function with all messages of a service. */
        subscribeToService(callback, name) {
            this.callbacks[name] = this.callbacks[name] || []
            if (this.callbacks[name].indexOf(callback) < 0) {
                this.callbacks[name].push(callback)
            }
        }

        unsubscribeFromService(callback, name) {
            this.callbacks[name] = (this.callbacks[name] || []).filter(one => one !== callback)
        }

        /** Returns the last state of a service. */
        getService(name) {
            return this.states[name]
        }

        getServices() {
            return this.services
        }

        /**
         * Returns the msg of a panel: send, subscribe and so on for one service, and a function for each of its
         * methods.
         */
        createMsgInterface(name) {
            this.interfaces[name] = this.interfaces[name] || this.makeInterface(name)
            this.addMethods(name)
            return this.interfaces[name]
        }

        makeInterface(name) {
            return {
                name,
                getName: () => name,
                send: (...call) => this.sendTo(name, ...call),
                sendBlocking: (...call) => this.sendBlocking(name, ...call),
                sendTo: (...call) => this.sendTo(...call),
                subscribe: what => {
                    if (typeof what === 'string') {
                        this.shown[name + ' ' + what] = true
                        this.subscribe(name, what)
                    } else {
                        this.subscribeToService(what.onMsg, name)
                        this.subscribe(name, 'publishState')
                        this.sendTo(name, 'broadcastState')
                    }
                },
                unsubscribe: what => {
                    if (typeof what === 'string') {
                        this.unsubscribe(name, what)
                    } else {
                        this.unsubscribeFromService(what.onMsg, name)
                    }
                }
            }
        }

        addMethods(name) {
            const target = this.interfaces[name]
            if (target) {
                (this.methods[name] || []).filter(method => OWN.indexOf(method) < 0).forEach(method => {
                    target[method] = (...data) => target.send(method, ...data)
                })
            }
        }
    }

    angular.module('mrlapp.mrl', []).service('mrl', ['$rootScope', '$q', Mrl])
}
