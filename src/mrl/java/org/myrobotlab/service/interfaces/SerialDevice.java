package org.myrobotlab.service.interfaces;

import java.io.IOException;
import org.myrobotlab.framework.interfaces.Attachable;

/** What can be done with a serial port. */
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

    /** Forgets what has come in and was not read. */
    void clear();

    /** How long a read waits. */
    void setTimeout(int timeoutMs);

    /** Sends what waits. */
    void flush();

    /** Bytes that can be read at once. */
    int available();

    /** Closes the port. */
    void close() throws IOException;

    /** Baud rate. */
    int getRate();

    /** Data bits. */
    int getDataBits();

    /** Stop bits. */
    int getStopBits();

    /** 0 none, 1 odd, 2 even. */
    int parity();
}
