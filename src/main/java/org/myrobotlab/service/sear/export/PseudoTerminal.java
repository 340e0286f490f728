package org.myrobotlab.service.sear.export;

import com.sun.jna.Library;
import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.NativeLong;
import com.sun.jna.Platform;
import com.sun.jna.Pointer;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A pseudo-terminal in raw mode, which any program opens like a serial port; programs may come and go. What comes while none has it open is gone, and
 * what a program did not read is gone when it closes, as on a real port. Linux and macOS; macOS forgets the settings of a terminal that nobody has
 * open, so there a side of its own is kept open, and a program may get up to 4 kB of old bytes.
 */
final class PseudoTerminal implements ExternalEndpoint {
    private static final Logger log = LoggerFactory.getLogger(PseudoTerminal.class);
    private static final int READ_WRITE = 2;
    private static final int NO_CONTROLLING_TERMINAL = Platform.isMac() ? 0x20000 : 0x100;
    private static final int NOT_BLOCKING = Platform.isMac() ? 0x4 : 0x800;
    private static final int SET_FLAGS = 4;
    private static final int NOW = 0;
    private static final int FLUSH_INPUT = Platform.isMac() ? 1 : 0;
    private static final int TERMIOS_SIZE = 256;
    private static final int BUFFER = 4096;
    private static final int POLL_MILLIS = 100;
    /** How often a terminal that nobody has open is looked at. */
    private static final int CLOSED_MILLIS = 10;
    private static final short POLL_IN = 1;
    private static final short POLL_HANG_UP = 0x10;
    private static final int EVENTS_AT = Integer.BYTES;
    private static final int FOUND_AT = Integer.BYTES + Short.BYTES;
    private static final int NONE = -1;
    /** Set while the device's rate is not known yet: one that no program sets. */
    private static final int UNKNOWN_BAUD = 50;
    /** Linux's codes of baud rates (asm-generic/termbits.h). macOS uses the numbers themselves. */
    private static final int[][] LINUX_BAUDS = {{UNKNOWN_BAUD, 0x1}, {300, 0x7}, {600, 0x8}, {1200, 0x9}, {2400, 0xB}, {4800, 0xC}, {9600, 0xD},
        {19200, 0xE}, {38400, 0xF}, {57600, 0x1001}, {115200, 0x1002}, {230400, 0x1003}, {460800, 0x1004}, {500000, 0x1005}, {1000000, 0x1008}};
    /** Linux's TCGETS2, whose termios2 has the rate as a number, those without a code (14400, 28800) too. */
    private static final long GET_TERMIOS_2 = 0x802C542AL;
    private static final int OUTPUT_SPEED = 40;
    /** Linux's TIOCPKT: before what is read there stands a byte, 0 for bytes of a program, or what it did to the terminal. */
    private static final long PACKETS = 0x5420;
    private static final byte HAS_SET = 0x40;
    private static final int PACKET_HEADER = 1;
    /** Linux's EXTPROC among a terminal's local flags: whatever a program sets is then told, even if it is what was set already. */
    private static final int TELL_SETTING = 0x10000;
    private static final int LOCAL_FLAGS = 12;
    /** ISIG, ICANON, ECHO; INLCR, IGNCR, ICRNL, IXON: what the system leaves to others while {@link #TELL_SETTING}. */
    private static final int LOCAL_PROCESSING = 0xB;
    private static final int INPUT_PROCESSING = 0x5C0;

    private final String port;
    private final C c;
    private final int master;
    /** macOS: the side kept open; {@link #NONE} elsewhere. */
    private final int slave;
    private final String path;
    private final TerminalLink link;
    private final Memory writeDescriptor = new Memory(Long.BYTES);
    private volatile boolean open = true;
    private boolean unread;
    /** Bytes before those of a program in what is read. */
    private final int header;
    /** What the terminal was set to here; where the system doesn't tell that a program sets it, one that sets this rate has set none. */
    private int ownBaud = UNKNOWN_BAUD;
    private volatile LineEnd end;
    private Thread reader;

    /** What is used of the C library. */
    interface C extends Library {
        int posix_openpt(int flags);

        int grantpt(int fd);

        int unlockpt(int fd);

        String ptsname(int fd);

        int open(String path, int flags);

        int close(int fd);

        NativeLong read(int fd, byte[] buffer, NativeLong count);

        NativeLong write(int fd, byte[] buffer, NativeLong count);

        int fcntl(int fd, int command, int value);

        int poll(Pointer descriptors, NativeLong count, int millis);

        int tcgetattr(int fd, Pointer termios);

        int tcsetattr(int fd, int when, Pointer termios);

        int ioctl(int fd, NativeLong request, Pointer argument);

        void cfmakeraw(Pointer termios);

        NativeLong cfgetospeed(Pointer termios);

        int cfsetspeed(Pointer termios, NativeLong speed);

        int tcflush(int fd, int what);
    }

    private PseudoTerminal(String port, C c, int master, int slave, String path, TerminalLink link) {
        this.port = port;
        this.c = c;
        this.master = master;
        this.slave = slave;
        this.path = path;
        this.link = link;
        this.header = reportSettings(true) ? PACKET_HEADER : 0;
    }

    /** @param link symbolic link to make, or null */
    static PseudoTerminal open(String port, Path link) throws IOException {
        if (!Platform.isLinux() && !Platform.isMac()) {
            throw new IOException("this system has no pseudo-terminals: use exportTcp(\"" + port + "\", 0)");
        }
        C c;
        try {
            c = Native.load("c", C.class);
        } catch (LinkageError e) {
            throw new IOException("pseudo-terminals need JNA (jna-5.19.1.jar in libraries/jar): use exportTcp, or install it", e);
        }
        int master = c.posix_openpt(READ_WRITE | NO_CONTROLLING_TERMINAL);
        if (master < 0 || c.grantpt(master) != 0 || c.unlockpt(master) != 0) {
            closeIfOpen(c, master);
            throw new IOException("the system gave no pseudo-terminal (error " + Native.getLastError() + ")");
        }
        String path = c.ptsname(master);
        int slave = c.open(path, READ_WRITE | NO_CONTROLLING_TERMINAL);
        if (slave < 0 || c.fcntl(master, SET_FLAGS, NOT_BLOCKING) != 0) {
            closeIfOpen(c, slave);
            closeIfOpen(c, master);
            throw new IOException("the pseudo-terminal " + path + " can't be opened (error " + Native.getLastError() + ")");
        }
        makeRaw(c, slave);
        int kept = Platform.isMac() ? slave : NONE;
        if (kept == NONE) {
            c.close(slave);
        }
        try {
            return new PseudoTerminal(port, c, master, kept, path, link == null ? null : TerminalLink.make(link, path));
        } catch (IOException | RuntimeException e) {
            closeIfOpen(c, kept);
            closeIfOpen(c, master);
            throw e;
        }
    }

    private static void closeIfOpen(C c, int fd) {
        if (fd >= 0) {
            c.close(fd);
        }
    }

    private static void makeRaw(C c, int slave) {
        Memory termios = new Memory(TERMIOS_SIZE);
        c.tcgetattr(slave, termios);
        c.cfmakeraw(termios);
        if (Platform.isLinux()) {
            termios.setInt(LOCAL_FLAGS, termios.getInt(LOCAL_FLAGS) | TELL_SETTING);
        }
        c.cfsetspeed(termios, new NativeLong(codeOf(UNKNOWN_BAUD)));
        c.tcsetattr(slave, NOW, termios);
    }

    private static int codeOf(int baud) {
        return Platform.isMac() ? baud : translated(baud, 0, 1);
    }

    /** The path for programs to open. */
    String getPath() {
        return link == null ? path : link.toString();
    }

    @Override
    public String describe() {
        return "pseudo-terminal " + getPath();
    }

    /** Programs that don't set a rate find the device's. */
    @Override
    public synchronized void deviceAt(int baud) {
        Memory termios = new Memory(TERMIOS_SIZE);
        boolean free = open && baud > 0 && codeOf(baud) > 0 && (end == null || end.getBaud() == 0) && currentBaud(termios) == ownBaud;
        if (free) {
            reportSettings(false);
            c.tcgetattr(side(), termios);
            c.cfsetspeed(termios, new NativeLong(codeOf(baud)));
            c.tcsetattr(side(), NOW, termios);
            reportSettings(true);
            ownBaud = currentBaud(termios);
        }
    }

    /** Where settings are read and made. */
    private int side() {
        return Platform.isMac() ? slave : master;
    }

    /**
     * Linux: has the system tell at the master what programs set. What is set here is not to be told.
     *
     * @return whether it does
     */
    private boolean reportSettings(boolean on) {
        Memory wanted = new Memory(Integer.BYTES);
        wanted.setInt(0, on ? 1 : 0);
        return Platform.isLinux() && c.ioctl(master, new NativeLong(PACKETS, true), wanted) == 0;
    }

    @Override
    public void start(LineEnd lineEnd) {
        end = lineEnd;
        reader = new Thread(this::read, "pseudo-terminal of " + port);
        reader.setDaemon(true);
        reader.start();
    }

    private void read() {
        Memory descriptor = new Memory(Long.BYTES);
        Memory termios = new Memory(TERMIOS_SIZE);
        byte[] buffer = new byte[BUFFER];
        boolean inUse = false;
        while (open) {
            int found = poll(descriptor, POLL_MILLIS);
            boolean hungUp = (found & POLL_HANG_UP) != 0;
            if (!hungUp && !inUse && open) {
                end.opened();
                inUse = true;
            }
            int count = (found & POLL_IN) != 0 ? take(buffer) : 0;
            boolean set = header > 0 && count > 0 && (buffer[0] & HAS_SET) != 0;
            inUse |= reportBaud(set, termios);
            if (count > header) {
                end.send(Arrays.copyOfRange(buffer, header, count));
                inUse = true;
            } else if (count <= 0 && hungUp && open) {
                if (inUse) {
                    end.closed();
                    inUse = false;
                }
                forgetUnread();
                c.poll(null, new NativeLong(0), CLOSED_MILLIS);
            }
        }
    }

    /** Never together with {@link #deviceAt}, which changes for a moment what is read. */
    private synchronized int take(byte[] buffer) {
        return open ? c.read(master, buffer, new NativeLong(buffer.length)).intValue() : 0;
    }

    /**
     * Looks at the terminal's rate.
     *
     * @param set whether the system has told that a program sets something
     * @return whether a program has set a rate, be it the one that was there
     */
    private synchronized boolean reportBaud(boolean set, Memory termios) {
        int baud = open ? currentBaud(termios) : 0;
        boolean changed = baud > 0 && (set || baud != (end.getBaud() > 0 ? end.getBaud() : ownBaud));
        if (changed) {
            end.setBaud(baud);
        }
        if (set && open) {
            leaveProcessing(termios);
        }
        return changed;
    }

    /** A program that wants whole lines, or other input than the bytes as they are, gets it from the system; its rate is known already. */
    private void leaveProcessing(Memory termios) {
        c.tcgetattr(side(), termios);
        int local = termios.getInt(LOCAL_FLAGS);
        if ((local & TELL_SETTING) != 0 && ((local & LOCAL_PROCESSING) != 0 || (termios.getInt(0) & INPUT_PROCESSING) != 0)) {
            termios.setInt(LOCAL_FLAGS, local & ~TELL_SETTING);
            c.tcsetattr(side(), NOW, termios);
        }
    }

    /** What there is at the master, {@link #POLL_IN} and {@link #POLL_HANG_UP}; the latter while no program has the terminal open. */
    private int poll(Memory descriptor, int millis) {
        descriptor.setInt(0, master);
        descriptor.setShort(EVENTS_AT, POLL_IN);
        descriptor.setShort(FOUND_AT, (short) 0);
        return c.poll(descriptor, new NativeLong(1), millis) > 0 ? descriptor.getShort(FOUND_AT) : 0;
    }

    /** The last program has closed the terminal: what it did not read is not for the next one. */
    private synchronized void forgetUnread() {
        int side = open && unread ? c.open(path, READ_WRITE | NO_CONTROLLING_TERMINAL) : NONE;
        if (side >= 0) {
            c.tcflush(side, FLUSH_INPUT);
            c.close(side);
            unread = false;
        }
    }

    /** 0 for a rate that the system doesn't tell, and while a program hangs up. */
    private int currentBaud(Pointer termios) {
        if (Platform.isLinux() && c.ioctl(master, new NativeLong(GET_TERMIOS_2, true), termios) == 0) {
            return termios.getInt(OUTPUT_SPEED);
        }
        c.tcgetattr(side(), termios);
        int code = c.cfgetospeed(termios).intValue();
        return Platform.isMac() ? code : translated(code, 1, 0);
    }

    private static int translated(int value, int from, int to) {
        return Arrays.stream(LINUX_BAUDS).filter(known -> known[from] == value).mapToInt(known -> known[to]).findFirst().orElse(0);
    }

    @Override
    public synchronized void write(byte[] bytes) {
        if (open && (poll(writeDescriptor, 0) & POLL_HANG_UP) != 0) {
            return;
        }
        for (int done = 0; open && done < bytes.length;) {
            byte[] rest = Arrays.copyOfRange(bytes, done, bytes.length);
            int written = c.write(master, rest, new NativeLong(rest.length)).intValue();
            if (written > 0) {
                unread = true;
                done += written;
            } else {
                log.debug("nobody reads {}: bytes are thrown away", path);
                if (slave != NONE) {
                    c.tcflush(slave, FLUSH_INPUT);
                }
                done = bytes.length;
            }
        }
    }

    @Override
    public void close() {
        open = false;
        try {
            if (reader != null) {
                reader.join(10L * POLL_MILLIS);
            }
            if (link != null) {
                link.remove();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            log.warn("link {} was not removed: {}", link, e.toString());
        }
        synchronized (this) {
            closeIfOpen(c, slave);
            c.close(master);
        }
    }
}
