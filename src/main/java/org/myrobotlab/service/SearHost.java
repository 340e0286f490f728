// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import org.myrobotlab.framework.MRLListener;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.data.ImageData;
import org.myrobotlab.service.link.ServiceWarnings;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.SensorReading;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Passes what happens in the simulation to its service. */
final class SearHost implements Host {
    /** The command line prints this logger's messages. */
    private static final Logger PROGRESS = LoggerFactory.getLogger("org.SEAR.progress");
    private static final String STATE = "publishSimulation";
    private static final String IMAGE = "publishImage";

    private final SEAR service;
    private final SearCalls calls;

    SearHost(SEAR service, SearCalls calls) {
        this.service = service;
        this.calls = calls;
    }

    @Override
    public long queries() {
        return calls.count();
    }

    @Override
    public String getName() {
        return service.getName();
    }

    @Override
    public String getResourceRoot() {
        return Service.getResourceRoot();
    }

    @Override
    public void progress(String message) {
        service.info("%s", message);
        PROGRESS.info(message);
    }

    @Override
    public void warn(String message) {
        ServiceWarnings.publish(service, "%s", message);
    }

    @Override
    public void error(String message) {
        service.error("%s", message);
    }

    @Override
    public void windowClosed() {
        if (service.getConfig().closingWindowStops) {
            // send() would call it on this thread
            service.in(Message.createMessage(service.getName(), service.getName(), "stopSimulation", new Object[0]));
        }
    }

    @Override
    public boolean isReadingHeard() {
        return isHeard("publishReading");
    }

    private boolean isHeard(String topic) {
        List<MRLListener> listeners = service.getNotifyList(topic);
        return listeners != null && !listeners.isEmpty();
    }

    @Override
    public boolean isImageHeard() {
        return isHeard(IMAGE);
    }

    /** Publishes a picture in MyRobotLab's usual form, with a URL that a page can show. */
    @Override
    public void image(String camera, byte[] png) {
        ImageData image = new ImageData("data:image/png;base64," + Base64.getEncoder().encodeToString(png));
        image.name = camera;
        image.source = service.getName();
        image.encoding = "png";
        service.invoke(IMAGE, image);
    }

    @Override
    public void reading(SensorReading reading) {
        service.invoke("publishReading", reading);
    }

    @Override
    public void kept(Path backup, String words) {
        service.invoke("publishKept", Map.of("path", backup.toString(), "words", words));
    }

    @Override
    public void state() {
        List<MRLListener> listeners = service.getNotifyList(STATE);
        if (listeners != null && !listeners.isEmpty()) {
            service.invoke(STATE);
        }
    }
}
