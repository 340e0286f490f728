// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.Serial;

/** The controller template answers as in the chips' data sheets and loses no request. */
@Category(Slow.class)
public class ControllerTemplateTest {
    private static final Path TEMPLATE = Paths.get(System.getProperty("sear.root", "."),
        "resources/templates/controller.py");
    private static final String USER_PORT = "/dev/user_CONTROLLER_01";

    private Python python;
    private Serial user;
    private Heard heard;

    @Before
    public void startController() throws Exception {
        python = (Python) Runtime.start("python", "Python");
        assertTrue(python.execFile(TEMPLATE.toString()));
        user = (Serial) Runtime.start("templateUser", "Serial");
        user.connect(USER_PORT, 9600, 8, 1, 0);
        heard = (Heard) Runtime.start("templateBytes", "Heard");
        user.addListener("publishRX", "templateBytes", "onValue");
    }

    @After
    public void release() {
        for (String name : new String[] {"templateUser", "templateBytes", "controllerSerial", "SEAR", "python"}) {
            Runtime.releaseService(name);
        }
    }

    private void assertPython(int expected, String expression) {
        assertTrue(python.exec("checked = int(" + expression + ")"));
        assertEquals(expression, expected, ((Number) python.get("checked")).intValue());
    }

    @Test
    public void thePingAnswersWholeCentimetres() {
        assertPython(126, "centimetres(1.256)");
        assertPython(0, "centimetres(0.004)");
    }

    @Test
    public void theAccelerometerAnswersLikeAnAdxl330() {
        assertPython(465, "adxl330(0)");
        assertPython(558, "adxl330(9.80665)");
        assertPython(372, "adxl330(-9.80665)");
        assertPython(744, "adxl330(3 * 9.80665)");
        assertPython(800, "adxl330(1000)");
        assertPython(130, "adxl330(-1000)");
    }

    @Test
    public void theGyroscopeAnswersLikeAnIdg500() {
        assertPython(418, "idg500(0)");
        assertPython(480, "idg500(math.radians(100))");
        assertPython(356, "idg500(math.radians(-100))");
        assertPython(729, "idg500(math.radians(900))");
        assertPython(108, "idg500(math.radians(-900))");
    }

    @Test
    public void theCompassAnswersLikeAnHmc6352() {
        assertPython(900, "hmc6352(90)");
        assertPython(3599, "hmc6352(-0.1)");
        assertPython(0, "hmc6352(0)");
        assertPython(1805, "hmc6352(-179.5)");
        assertPython(0, "hmc6352(359.99)");
    }

    @Test
    public void answersComeHighByteFirst() throws Exception {
        python.exec("sensorCommands[0x30] = lambda: [0x0384, 0x0E0F]");
        user.write(0x8E);
        user.write(0x30);
        assertEquals("[3, 132, 14, 15]", heard.await(4).toString());
    }

    @Test
    public void tenRequestsASecondAreAllAnswered() throws Exception {
        python.exec("sensorCommands[0x8E] = lambda: [0x8E8E]");
        for (int i = 0; i < 30; i++) {
            user.write(0x8E);
            user.write(0x8E);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(100));
        }
        assertEquals(60, heard.await(60).size());
    }

    @Test
    public void aBurstOfRequestsIsAllAnsweredInOrder() throws Exception {
        python.exec("count = [0]");
        python.exec("def counter():\n    count[0] += 1\n    return [count[0]]\nsensorCommands[0xFF] = counter");
        for (int i = 0; i < 100; i++) {
            user.write(new byte[] {(byte) 0x8E, (byte) 0xFF});
        }
        List<Object> bytes = heard.await(200);
        assertEquals(200, bytes.size());
        for (int i = 0; i < 100; i++) {
            assertEquals(i + 1, (Integer) bytes.get(2 * i) * 256 + (Integer) bytes.get(2 * i + 1));
        }
    }

    @Test
    public void bytesOutsideRequestsAreIgnored() throws Exception {
        python.exec("sensorCommands[0x2B] = lambda: [1]");
        user.write(new byte[] {0x2B, 0x2B, (byte) 0x8E, 1, (byte) 0x8E, 0x2B});
        assertEquals("[0, 1]", heard.await(2).toString());
    }

    @Test
    public void theScriptCanBeRunAgain() throws Exception {
        user.disconnect();
        assertTrue(python.execFile(TEMPLATE.toString()));
        user.connect(USER_PORT, 9600, 8, 1, 0);
        python.exec("sensorCommands[0x2B] = lambda: [7]");
        user.write(new byte[] {(byte) 0x8E, 0x2B});
        assertEquals("[0, 7]", heard.await(2).toString());
    }
}
