// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.io.Serializable;
import java.util.Date;
import java.util.Locale;

/** The computer on which this program runs. */
public class Platform implements Serializable {
    public static final String OS_LINUX = "linux";
    public static final String OS_MAC = "mac";
    public static final String OS_WINDOWS = "windows";
    public static final String ARCH_X86 = "x86";
    public static final String ARCH_ARM = "arm";
    public static final String UNKNOWN = "unknown";

    private static final long serialVersionUID = 1L;
    private static final Platform LOCAL = new Platform();

    private final String os;
    private final String arch;
    private final Date startTime = new Date();

    public Platform() {
        String osName = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        String osArch = System.getProperty("os.arch", "").toLowerCase(Locale.ROOT);
        os = osName.contains(OS_WINDOWS) ? OS_WINDOWS : osName.contains(OS_MAC) ? OS_MAC : osName.contains(OS_LINUX)
            ? OS_LINUX : UNKNOWN;
        arch = osArch.startsWith(ARCH_ARM) || osArch.startsWith("aarch") ? ARCH_ARM : ARCH_X86;
    }

    public static Platform getLocalInstance() {
        return LOCAL;
    }

    public String getOS() {
        return os;
    }

    public String getArch() {
        return arch;
    }

    /** Returns 32 or 64. */
    public int getOsBitness() {
        return System.getProperty("os.arch", "").contains("64") ? 64 : 32;
    }

    public int getJvmBitness() {
        return getOsBitness();
    }

    /** Returns for example x86.64.linux. */
    public String getPlatformId() {
        return arch + "." + getOsBitness() + "." + os;
    }

    /** Returns the version of MyRobotLab. */
    public String getVersion() {
        String version = Platform.class.getPackage().getImplementationVersion();
        return version == null ? "embedded" : version;
    }

    public String getVMName() {
        return System.getProperty("java.vm.name");
    }

    public String getVmVersion() {
        return System.getProperty("java.version");
    }

    public String getPid() {
        return Long.toString(ProcessHandle.current().pid());
    }

    public Date getStartTime() {
        return new Date(startTime.getTime());
    }

    public boolean isLinux() {
        return OS_LINUX.equals(os);
    }

    public boolean isMac() {
        return OS_MAC.equals(os);
    }

    public boolean isWindows() {
        return OS_WINDOWS.equals(os);
    }

    public boolean isArm() {
        return ARCH_ARM.equals(arch);
    }

    public boolean isX86() {
        return ARCH_X86.equals(arch);
    }

    public boolean isDalvik() {
        return false;
    }

    @Override
    public String toString() {
        return getPlatformId();
    }
}
