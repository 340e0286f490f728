/** The scenes of bodies of the benchmark in native Bullet, which brings its own com.jme3 classes and so runs by itself. Never shipped. */
package org.SEAR.benchmark.bullet;
