// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.embedded.Configs;
import org.myrobotlab.embedded.Main;
import org.myrobotlab.embedded.ErrorReasons;
import org.myrobotlab.embedded.Registry;
import org.myrobotlab.embedded.Shutdown;
import org.myrobotlab.embedded.StartOptions;
import org.myrobotlab.embedded.python.ServiceTypes;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Peer;
import org.myrobotlab.framework.Plan;
import org.myrobotlab.framework.Platform;
import org.myrobotlab.framework.Registration;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.interfaces.MessageListener;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.logging.LoggerFactory;
import org.myrobotlab.service.config.RuntimeConfig;
import org.myrobotlab.service.config.ServiceConfig;
import org.myrobotlab.service.interfaces.ServiceLifeCyclePublisher;
import org.slf4j.Logger;

/** Creates, starts and releases services. Any thread. */
public class Runtime extends Service<RuntimeConfig> implements MessageListener, ServiceLifeCyclePublisher {
    public static final Logger log = LoggerFactory.getLogger(Runtime.class);
    public static final String DATA_DIR = "data";
    public static final String ROOT_CONFIG_DIR = Configs.ROOT;

    protected static String configName = "default";

    private static final long serialVersionUID = 1L;
    private static final String NAME = "runtime";
    private static final Registry REGISTRY = new Registry();
    private static final Object LOCK = new Object();
    private static volatile Runtime instance;

    protected Integer creationCount = 0;
    volatile boolean processingConfig;
    protected Platform platform = Platform.getLocalInstance();

    public Runtime(String name, String id) {
        super(name, id);
    }

    /**
     * Starts MyRobotLab as a program: {@code java -cp "libraries/jar/*:myrobotlab.jar" org.myrobotlab.service.Runtime
     * -s sear SEAR}.
     */
    public static void main(String[] args) throws InterruptedException {
        StartOptions options;
        try {
            options = new StartOptions(args);
        } catch (IllegalArgumentException e) {
            System.err.println("myrobotlab: " + e.getMessage());
            System.exit(2);
            return;
        }
        Main.run(options);
    }

    // ---- the Runtime itself
    // -------------------------------------------------------------------------------------------

    /** Returns the Runtime of this process; starts it first if necessary. */
    public static Runtime getInstance() {
        Runtime found = instance;
        return found == null ? make() : found;
    }

    private static Runtime make() {
        synchronized (LOCK) {
            if (instance == null) {
                instance = new Runtime(NAME, Registry.ID);
                register(new Registration(instance));
                instance.startService();
            }
            return instance;
        }
    }

    public static Runtime get() {
        return getInstance();
    }

    /** Returns whether the Runtime exists. */
    public static boolean exists() {
        return instance != null;
    }

    @Override
    public boolean isRuntime() {
        return true;
    }

    @Override
    public void onMessage(Message msg) {
        log.debug("{}", msg);
    }

    // ---- making and starting
    // ------------------------------------------------------------------------------------------

    public static ServiceInterface create(String name) {
        return create(name, null);
    }

    /**
     * Creates a service, or returns the existing one of that name.
     *
     * @return null if it can't be created; an error status gives the reason
     */
    public static ServiceInterface create(String name, String type) {
        synchronized (LOCK) {
            ServiceInterface existing = getService(name);
            return existing != null ? existing : make(name, type);
        }
    }

    public static ServiceInterface start(String name) {
        return start(name, null);
    }

    /**
     * Creates and starts a service. Returns an existing one of that name, of any type, and starts it if it reports that
     * it is not running.
     *
     * @return null if it can't start; an error status gives the reason
     */
    public static ServiceInterface start(String name, String type) {
        synchronized (LOCK) {
            ServiceInterface existing = getService(name);
            if (existing != null) {
                return startAgain(existing) ? existing : null;
            }
            ServiceInterface service = create(name, type);
            if (service == null) {
                return null;
            }
            for (Peer peer : new ArrayList<>(service.getPeers().values())) {
                if (peer.autoStart) {
                    start(peer.name, peer.type);
                }
            }
            return started(service) ? service : null;
        }
    }

    /** Starts a service that reports that it is not running, even if it is. */
    private static boolean startAgain(ServiceInterface existing) {
        try {
            if (!existing.isRunning()) {
                existing.startService();
            }
            return true;
        } catch (RuntimeException e) {
            getInstance().error(e);
            return false;
        }
    }

    private static boolean started(ServiceInterface service) {
        try {
            service.startService();
            return true;
        } catch (RuntimeException | LinkageError e) {
            refuse(service.getName(), service.getSimpleName(), e);
            service.releaseService();
            return false;
        }
    }

    /** Same as start, under the name that older scripts use. */
    public static ServiceInterface createAndStart(String name, String type) {
        return start(name, type);
    }

    public static ServiceInterface loadAndStart(String name, String type) {
        return start(name, type);
    }

    private static ServiceInterface make(String name, String type) {
        Runtime runtime = getInstance();
        try {
            String shortName = checked(name);
            ServiceConfig config = runtime.readServiceConfig(shortName);
            String given = type != null ? type : config == null ? null : config.type;
            if (given == null) {
                throw new IllegalArgumentException("its type is missing, and there is no configuration file of that "
                    + "name: write "
                    + (ServiceTypes.isKnown(shortName) ? "Runtime.start(\"name\", \"" + shortName + "\")"
                        : "Runtime.start(\"" + shortName + "\", \"SEAR\")") + " with a name and a type");
            }
            Service<?> service = instantiate(shortName, given, runtime.getId());
            service.setOrder(++runtime.creationCount);
            if (config == null) {
                service.apply();
            } else {
                apply(service, config);
            }
            runtime.invoke("created", service.getFullName());
            register(new Registration(service));
            return service;
        } catch (ReflectiveOperationException | RuntimeException | LinkageError e) {
            refuse(name, type, e);
            return null;
        }
    }

    private static String checked(String name) {
        String shortName = CodecUtils.getShortName(name);
        if (shortName == null || shortName.trim().isEmpty() || shortName.contains("/")) {
            throw new IllegalArgumentException("a service's name is a word without \"/\"");
        }
        return shortName;
    }

    private static Service<?> instantiate(String name, String type, String id) throws ReflectiveOperationException {
        Class<?> found;
        try {
            found = Class.forName(CodecUtils.makeFullTypeName(type));
        } catch (ClassNotFoundException | NoClassDefFoundError e) {
            String wanted = CodecUtils.makeFullTypeName(type);
            if (String.valueOf(e.getMessage()).replace('/', '.').contains(wanted)) {
                throw new IllegalArgumentException(ServiceTypes.missing(CodecUtils.getSimpleName(type)), e);
            }
            throw e;
        }
        if (!Service.class.isAssignableFrom(found)) {
            throw new IllegalArgumentException(type + " is not a service type");
        }
        return (Service<?>) found.getConstructor(String.class, String.class).newInstance(name, id);
    }

    @SuppressWarnings("unchecked")
    private static <C extends ServiceConfig> void apply(Service<C> service, ServiceConfig config) {
        service.apply((C) config);
    }

    /** Reports why a service can't start. A script that asked for it continues, and ends with status 1. */
    private static void refuse(String name, String type, Throwable why) {
        log.debug("{} {}", name, type, why);
        String reason = "can't start " + name + (type == null ? "" : " as " + CodecUtils.getSimpleName(type)) + ": "
            + ErrorReasons.of(why);
        getInstance().failCall("%s", reason);
    }

    // ---- the registry
    // -------------------------------------------------------------------------------------------------

    /** Registers a service that was created elsewhere. */
    public static Registration register(Registration registration) {
        REGISTRY.put(registration.service);
        getInstance().config.add(registration.service.getName());
        getInstance().invoke("registered", registration);
        return registration;
    }

    /** Removes a service from the registry. */
    public static void unregister(String name) {
        Runtime runtime = instance;
        if (runtime != null && REGISTRY.remove(CodecUtils.getFullName(name))) {
            runtime.config.remove(CodecUtils.getShortName(name));
            runtime.invoke("released", name);
        }
    }

    /** Returns the service of that name; null if there is none. */
    public static ServiceInterface getService(String name) {
        return name == null ? null : REGISTRY.get(CodecUtils.getFullName(name));
    }

    public static Map<String, ServiceInterface> getRegistry() {
        return REGISTRY.copy();
    }

    public static Map<String, ServiceInterface> getLocalServices() {
        return REGISTRY.copy();
    }

    public static List<ServiceInterface> getServices() {
        return new ArrayList<>(REGISTRY.copy().values());
    }

    /** Returns the full names of all services. */
    public static String[] getServiceNames() {
        return REGISTRY.copy().keySet().toArray(new String[0]);
    }

    public static List<ServiceInterface> getServicesFromInterface(Class<?> interfaze) {
        return getServices().stream().filter(interfaze::isInstance).collect(Collectors.toList());
    }

    public static List<String> getServiceNamesFromInterface(Class<?> interfaze) {
        return getServicesFromInterface(interfaze).stream().map(ServiceInterface::getFullName)
            .collect(Collectors.toList());
    }

    public List<Registration> getServiceList() {
        return getServices().stream().map(Registration::new).collect(Collectors.toList());
    }

    public static boolean isStarted(String name) {
        ServiceInterface service = getService(name);
        return service != null && service.isRunning();
    }

    public static boolean isLocal(String name) {
        return CodecUtils.isLocal(name);
    }

    public static String getFullName(String name) {
        return CodecUtils.getFullName(name);
    }

    public static Platform getPlatform() {
        return getInstance().platform;
    }

    public static String getVersion() {
        return getPlatform().getVersion();
    }

    // ---- releasing
    // ----------------------------------------------------------------------------------------------------

    /** Stops a service and removes it from the registry. */
    public static void release(String name) {
        releaseService(name);
    }

    /** @return whether there was a service of that name */
    public static boolean releaseService(String name) {
        ServiceInterface service = getService(name);
        if (service != null) {
            service.releaseService();
        }
        return service != null;
    }

    /** Releases all services, the newest first, and the Runtime. */
    public static void releaseAll() {
        releaseAll(true, true);
    }

    public static void releaseAll(boolean releaseRuntime, boolean block) {
        for (ServiceInterface service : REGISTRY.newestFirst()) {
            if (!service.isRuntime() && REGISTRY.get(service.getFullName()) == service) {
                attempt(service, ServiceInterface::releaseService);
            }
        }
        Runtime runtime = instance;
        if (releaseRuntime && runtime != null) {
            runtime.releaseService();
        }
    }

    /** Runs a step of the shutdown; a service that fails does not stop the others from ending. */
    private static void attempt(ServiceInterface service, Consumer<ServiceInterface> part) {
        try {
            part.accept(service);
        } catch (RuntimeException e) {
            log.error("{} did not end as it should: {}", service.getName(), ErrorReasons.of(e), e);
        }
    }

    @Override
    public void releaseService() {
        super.releaseService();
        synchronized (LOCK) {
            REGISTRY.remove(getFullName());
            if (instance == this) {
                instance = null;
            }
        }
    }

    /** Releases everything and ends the program. */
    public static void shutdown() {
        for (ServiceInterface service : REGISTRY.newestFirst()) {
            attempt(service, ServiceInterface::preShutdown);
        }
        releaseAll();
        Shutdown.run();
    }

    // ---- configuration
    // ------------------------------------------------------------------------------------------------

    /** Returns the default configurations of a service and its peers. */
    public static Plan load(String name, String type) {
        return ServiceConfig.getDefault(new Plan(name), name, type);
    }

    /** Reads the service's configuration file; null if there is none. */
    public ServiceConfig readServiceConfig(String name) {
        return readServiceConfig(configName, name);
    }

    public ServiceConfig readServiceConfig(String set, String name) {
        return Configs.read(set, name);
    }

    public static void saveConfig(String name, ServiceConfig config) throws IOException {
        Configs.write(configName, CodecUtils.getShortName(name), config);
    }

    /**
     * Saves the configurations of all services; the Runtime's lists their names.
     *
     * @return whether all were saved
     */
    public static boolean saveConfig(String set) {
        return getInstance().saveService(set, null, null);
    }

    /**
     * Saves the configuration of a service, or of all.
     *
     * @param set name of the set of configurations, which becomes the current one
     * @param serviceName null for all services
     * @param fileName not used: the file is named after the service
     * @return whether they were saved
     */
    public boolean saveService(String set, String serviceName, String fileName) {
        setConfig(set);
        ServiceInterface single = getService(serviceName);
        if (serviceName != null && single == null) {
            failCall("the configuration of %s can't be written: there is no such service", serviceName);
            return false;
        }
        List<ServiceInterface> all = serviceName == null ? getServices() : List.of(single);
        try {
            for (ServiceInterface one : all) {
                saveConfig(one.getName(), one.getFilteredConfig());
            }
            return true;
        } catch (IOException e) {
            failCall("configuration %s can't be written: %s", set, e.getMessage());
            return false;
        }
    }

    /**
     * Creates the services of a saved set, and then starts them. The first one that throws stops this, as in the real
     * MyRobotLab.
     */
    public static void startConfig(String set) {
        setConfig(set);
        Runtime runtime = getInstance();
        ServiceConfig saved = runtime.readServiceConfig("runtime");
        if (!(saved instanceof RuntimeConfig)) {
            runtime.failCall("there is no saved configuration %s: its runtime.yml is missing", set);
            return;
        }
        runtime.processingConfig = true;
        runtime.invoke("publishConfigStarted", set);
        try {
            runtime.startAll(((RuntimeConfig) saved).getRegistry());
            runtime.invoke("publishConfigFinished", set);
        } finally {
            runtime.processingConfig = false;
        }
    }

    private void startAll(List<String> names) {
        List<ServiceInterface> made = new ArrayList<>();
        for (String name : names) {
            if (!NAME.equals(name) && !isStarted(name)) {
                ServiceInterface service = create(name);
                if (service != null) {
                    made.add(service);
                }
            }
        }
        for (ServiceInterface service : made) {
            try {
                service.startService();
            } catch (RuntimeException e) {
                error(e);
                throw e;
            }
        }
    }

    /** Returns whether the services of a saved set are being started. */
    public boolean isProcessingConfig() {
        return processingConfig;
    }

    public String publishConfigStarted(String set) {
        return set;
    }

    public String publishConfigFinished(String set) {
        return set;
    }

    public static String setConfig(String name) {
        configName = name;
        return name;
    }

    public String getConfigName() {
        return configName;
    }

    // ---- published methods ------------------------------------------------------------------------------------------

    @Override
    public String created(String name) {
        return name;
    }

    @Override
    public Registration registered(Registration registration) {
        return registration;
    }

    @Override
    public String started(String name) {
        return name;
    }

    @Override
    public String stopped(String name) {
        return name;
    }

    @Override
    public String released(String name) {
        return name;
    }
}
