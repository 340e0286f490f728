/**
 * {@code sear sweep}: hands over to the package for Python 3, which deals the runs out by Dask; and one run of a Jython script after the other, for
 * its processes. Uses {@link org.myrobotlab.service} and {@link org.myrobotlab.embedded.python}, and what these use. The main thread.
 */
package org.SEAR.cli.sweep;
