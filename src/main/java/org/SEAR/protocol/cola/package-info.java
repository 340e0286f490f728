// SPDX-License-Identifier: Apache-2.0
/**
 * SICK's Command Language of LMS1xx and TiM scanners, CoLa A (text) and CoLa B (binary): frames and values, for the
 * simulated scanner and for drivers. Uses no other package of SEAR. A reader serves one thread.
 */
package org.SEAR.protocol.cola;
