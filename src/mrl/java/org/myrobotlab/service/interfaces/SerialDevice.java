// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import java.io.IOException;
import org.myrobotlab.framework.interfaces.Attachable;

/** Operations of a serial port. */
public interface SerialDevice extends PortPublisher, Attachable {
    /** Opens a port. */
    void open(String name) throws IOException;

    /** Opens a port. */
    void open(String name, int rate, int dataBits, int stopBits, int parity) throws IOException;

    /** Waits for a byte, 0 to 255. */
    int read() throws Exception;

    /** Sends bytes. */
    void write(byte[] data) throws Exception;

    /** Sends the low 8 bits. */
    void write(int data) throws Exception;

    /** Sends text. */
    void write(String data) throws Exception;

    /** Discards received bytes that were not read. */
    void clear();

    /** Sets how long a read waits, ms. */
    void setTimeout(int timeoutMs);

    /** Sends all waiting bytes. */
    void flush();

    /** Number of bytes that can be read without waiting. */
    int available();

    /** Closes the port. */
    void close() throws IOException;

    /** Baud rate. */
    int getRate();

    /** Data bits. */
    int getDataBits();

    /** Stop bits. */
    int getStopBits();

    /** Parity: 0 none, 1 odd, 2 even. */
    int parity();
}
