package org.SEAR.devices.lms;

import org.SEAR.protocol.lms.Variant;

/** Which values of a scan a telegram carries, and in what form. Immutable. */
final class ScanFormat {
    /** Every value, B0h. */
    static final ScanFormat ALL = new ScanFormat(Form.EVERY, 1, 1, 0, 0);
    /** One turn of the mirror, B0h. */
    static final ScanFormat PARTIAL = new ScanFormat(Form.PARTIAL, 1, 1, 0, 0);
    /** The smallest distance from the line through the device's sides, B0h. */
    static final ScanFormat MINIMUM = new ScanFormat(Form.MINIMUM, 1, 1, 0, 0);
    /** The taught contour, B0h. */
    static final ScanFormat CONTOUR = new ScanFormat(Form.CONTOUR, 1, 1, 0, 0);

    /** Forms of the values. */
    enum Form { EVERY, PARTIAL, MINIMUM, CONTOUR, MEAN, RANGE, MEAN_RANGE }

    final Form form;
    /** Every so many-th value. */
    final int stride;
    /** Number of scans the mean is taken of. */
    final int scans;
    /** First and last value of a sub-range, from 1. */
    final int first;
    final int last;

    private ScanFormat(Form form, int stride, int scans, int first, int last) {
        this.form = form;
        this.stride = stride;
        this.scans = scans;
        this.first = first;
        this.last = last;
    }

    /** Every {@code stride}-th value, B0h. */
    static ScanFormat every(int stride) {
        return new ScanFormat(Form.EVERY, stride, 1, 0, 0);
    }

    /** Mean of so many scans, B6h. */
    static ScanFormat mean(int scans) {
        return new ScanFormat(Form.MEAN, 1, scans, 0, 0);
    }

    /** Values first to last, from 1, B7h. */
    static ScanFormat range(int first, int last) {
        return new ScanFormat(Form.RANGE, 1, 1, first, last);
    }

    /** Mean of values first to last, BFh. */
    static ScanFormat meanRange(int scans, int first, int last) {
        return new ScanFormat(Form.MEAN_RANGE, 1, scans, first, last);
    }

    /** Seconds that one of the scans takes. */
    double scanTime(Variant variant) {
        return form == Form.PARTIAL ? Variant.TURN : variant.getScanTime();
    }
}
