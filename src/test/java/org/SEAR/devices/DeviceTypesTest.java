// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.ServiceLoader;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.gps.GpsModel;
import org.SEAR.devices.gps.GpsType;
import org.SEAR.devices.oi.OiModel;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.xml.ObjectClasses;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.protocol.lidar.LidarProtocol;
import org.SEAR.protocol.lms.Variant;
import org.junit.Rule;
import org.junit.Test;

/** The registry of devices, and names of models. */
public class DeviceTypesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void theThreeDevicesAreFoundByTheirObjects() {
        List<String> found = new ArrayList<>();
        for (DeviceType type : ServiceLoader.load(DeviceType.class)) {
            found.add(type.parameterType().getSimpleName());
        }
        assertTrue(found.toString(), found.containsAll(Arrays.asList("LIDAR", "Dynamics", "GPS")));
    }

    /** Like a sensor, a registered device needs its class named nowhere else. */
    @Test
    public void theClassOfARegisteredDeviceIsReadFromFiles() {
        List<Class<? extends SearObject>> registered = new ArrayList<>();
        ServiceLoader.load(ObjectTypes.class).forEach(more -> registered.addAll(more.types()));
        List<Class<? extends SearObject>> readable = ObjectClasses.find().all();
        for (DeviceType type : ServiceLoader.load(DeviceType.class)) {
            assertTrue(type.toString(), registered.contains(type.parameterType())
                && readable.contains(type.parameterType()));
        }
        assertEquals("no sensor, and registered by its device alone", Arduino.class, readable.get(readable.size() - 1));
    }

    /** Another jar may simulate a LIDAR that is not an LMS200. */
    @Test
    public void theNextTypeIsTriedIfOneHasNoDeviceForAnObject() {
        GPS gps = new GPS("gps", 48, 300, 11);
        SerialDevice device = new GpsType().create(gps, new FakeContext());
        DeviceTypes types = new DeviceTypes(
            Arrays.asList(type(GPS.class, null), type(LIDAR.class, null), type(LIDAR.class, device)));
        assertSame(device, types.create(new LIDAR("lidar"), new FakeContext()));
        assertNull(types.create(gps, new FakeContext()));
        assertTrue(types.isKnown(gps) && !types.isKnown(new Compass("compass")));
    }

    private static DeviceType type(Class<? extends SearObject> of, SerialDevice device) {
        return new DeviceType() {
            @Override
            public Class<? extends SearObject> parameterType() {
                return of;
            }

            @Override
            public SerialDevice create(SearObject parameters, DeviceContext context) {
                return device;
            }
        };
    }

    @Test
    public void aTypeHandlesOnlyItsModels() {
        LIDAR lidar = new LIDAR("lidar");
        FakeContext line = new FakeContext();
        for (LidarModel model : LidarModel.values()) {
            lidar.setModel(model.getName());
            assertEquals(model.getName(), model.getProtocol() == LidarProtocol.LMS,
                LidarSettings.of(lidar, LidarProtocol.LMS, line) != null);
        }
        lidar.LMS(0);
        assertNull(LidarSettings.of(lidar, LidarProtocol.RPLIDAR, line));
        assertTrue(line.warnings.toString(), line.warnings.isEmpty());
    }

    @Test
    public void settingsThatALidarModelLacksAreReported() {
        LIDAR lidar = new LIDAR("lidar");
        lidar.setModel("LMS111");
        lidar.setSpread(300);
        lidar.setBaud(9600);
        FakeContext line = new FakeContext();
        LidarSettings settings = LidarSettings.of(lidar, LidarProtocol.COLA, line);
        assertEquals("[spread 300.0 with resolution 0.5 is not available on an LMS111, legal: up to 270 with "
            + "0.5 or 0.25; its device starts with 270 and 0.25,"
            + " 9600 baud is not available on an LMS111, legal: 100000000; its device starts with 100000000]",
                line.warnings.toString());
        assertEquals("270.0 0.25 100000000", settings.spread + " " + settings.resolution + " " + settings.baud);
    }

    @Test
    public void modelsAreNamed() {
        assertEquals(OiModel.CREATE2, OiModel.of("create2"));
        assertEquals(GpsModel.MT3301, GpsModel.of("FV_M8"));
        assertEquals(GpsModel.MT3329, GpsModel.of("mt3329"));
        assertNull(Variant.of(180, 25));
    }

    /** Every legal model name has a receiver, so a valid project starts. */
    @Test
    public void anObjectAcceptsKnownReceiversInAnySpelling() {
        for (String name : Arrays.asList("FV_M8", "fv m11", "mt3329", "MT3301", "u-blox", "NEO-M8N")) {
            assertTrue(name, TextRule.GPS_MODEL.isLegal(name) && GpsModel.of(name) != null);
        }
        assertTrue(!TextRule.GPS_MODEL.isLegal("NEO-6M") && refusal(() -> GpsModel.of("NEO-6M")).contains("MT3329"));
    }

    @Test
    public void anUnknownModelIsRejectedWithTheKnownOnes() {
        assertTrue(refusal(() -> OiModel.of("create3")).contains("legal: roomba400, create, create2"));
        assertTrue(refusal(() -> GpsModel.of("x")).contains("MT3329"));
    }

    private static String refusal(Runnable call) {
        try {
            call.run();
        } catch (IllegalArgumentException e) {
            return e.getMessage();
        }
        return "accepted";
    }
}
