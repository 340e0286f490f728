// SPDX-License-Identifier: Apache-2.0
/**
 * Body scenes of the benchmark in native Bullet, which has its own com.jme3 classes and therefore runs in its own
 * process. Never shipped.
 */
package org.SEAR.benchmark.bullet;
