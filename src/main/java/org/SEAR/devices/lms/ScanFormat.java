// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import org.SEAR.protocol.lms.Variant;

/** Selection and form of a scan's values in a telegram. Immutable. */
final class ScanFormat {
    /** All values, B0h. */
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
    /** Interval of the values: every n-th. */
    final int stride;
    /** Number of scans in the mean. */
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

    /** Mean of several scans, B6h. */
    static ScanFormat mean(int scans) {
        return new ScanFormat(Form.MEAN, 1, scans, 0, 0);
    }

    /** Values first to last, from 1, B7h. */
    static ScanFormat range(int first, int last) {
        return new ScanFormat(Form.RANGE, 1, 1, first, last);
    }

    /** Mean of values first to last over several scans, BFh. */
    static ScanFormat meanRange(int scans, int first, int last) {
        return new ScanFormat(Form.MEAN_RANGE, 1, scans, first, last);
    }

    /** Duration of one of the scans, seconds. */
    double scanTime(Variant variant) {
        return form == Form.PARTIAL ? Variant.TURN : variant.getScanTime();
    }
}
