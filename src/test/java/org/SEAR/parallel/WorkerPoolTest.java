// SPDX-License-Identifier: Apache-2.0
package org.SEAR.parallel;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;
import org.junit.After;
import org.junit.Test;

/** All pieces are done once, in parallel, and nothing remains. */
public class WorkerPoolTest {
    private static final int ROUNDS = 20_000;
    private static final int MOST_ROUNDS = 200;

    private WorkerPool pool = new WorkerPool(1);

    @After
    public void close() {
        pool.close();
    }

    private void threads(int threads) {
        pool.close();
        pool = new WorkerPool(threads);
    }

    @Test
    public void eachPieceIsDoneOnce() {
        for (int threads : new int[] {1, 2, 4}) {
            threads(threads);
            for (int round = 0; round < ROUNDS; round++) {
                AtomicIntegerArray done = new AtomicIntegerArray(round % 9);
                pool.forEach(done.length(), done::incrementAndGet);
                for (int i = 0; i < done.length(); i++) {
                    assertEquals(threads + " threads, round " + round + ", piece " + i, 1, done.get(i));
                }
            }
        }
    }

    /** Each piece waits for all others, so each needs its own thread. */
    @Test(timeout = 600_000)
    public void asManyThreadsWorkAsWereAskedFor() {
        threads(4);
        Set<Thread> seen = ConcurrentHashMap.newKeySet();
        for (int round = 0; round < 3; round++) {
            CountDownLatch all = new CountDownLatch(4);
            pool.forEach(4, piece -> {
                seen.add(Thread.currentThread());
                all.countDown();
                await(all);
            });
        }
        assertEquals(seen.toString(), 4, seen.size());
        assertTrue("the caller works, too", seen.contains(Thread.currentThread()));
        pool.setThreads(1);
        seen.clear();
        pool.forEach(10, piece -> seen.add(Thread.currentThread()));
        assertEquals(Set.of(Thread.currentThread()), seen);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    public void theFirstFailureIsThrownWhenAllPiecesAreDone() {
        for (int threads : new int[] {2, 4}) {
            threads(threads);
            for (int round = 0; round < ROUNDS / 10; round++) {
                IllegalStateException[] thrown =
                    {new IllegalStateException("three"), new IllegalStateException("seven")};
                AtomicIntegerArray done = new AtomicIntegerArray(9);
                RuntimeException told = assertThrows(RuntimeException.class, () -> pool.forEach(9, piece -> {
                    done.incrementAndGet(piece);
                    if (piece == 3 || piece == 7) {
                        throw thrown[piece / 7];
                    }
                }));
                assertSame(thrown[0], told);
                for (int i = 0; i < done.length(); i++) {
                    assertEquals("piece " + i, 1, done.get(i));
                }
            }
            pool.forEach(9, piece -> { });    // and keeps no reference to the piece
        }
        assertSame(AssertionError.class, assertThrows(Error.class, () -> pool.forEach(2, piece -> {
            throw new AssertionError("an error");
        })).getClass());
    }

    @Test
    public void aPieceThatSharesWorkRunsItItself() {
        threads(4);
        AtomicIntegerArray done = new AtomicIntegerArray(8 * 8);
        Set<String> wrong = ConcurrentHashMap.newKeySet();
        pool.forEach(8, piece -> {
            Thread own = Thread.currentThread();
            pool.forEach(8, inner -> {
                done.incrementAndGet(8 * piece + inner);
                if (Thread.currentThread() != own) {
                    wrong.add("piece " + piece + " is shared");
                }
            });
        });
        assertEquals(Set.of(), wrong);
        for (int i = 0; i < done.length(); i++) {
            assertEquals("piece " + i, 1, done.get(i));
        }
    }

    @Test(timeout = 600_000)
    public void aClosedPoolHasNoThreadsAndWorksOn() {
        threads(3);
        Set<Thread> helpers = ConcurrentHashMap.newKeySet();
        CountDownLatch all = new CountDownLatch(3);
        pool.forEach(3, piece -> {
            helpers.add(Thread.currentThread());
            all.countDown();
            await(all);
        });
        helpers.remove(Thread.currentThread());
        assertEquals(2, helpers.size());
        pool.close();
        while (helpers.stream().anyMatch(Thread::isAlive)) {
            LockSupport.parkNanos(1000);
        }
        Set<Thread> seen = ConcurrentHashMap.newKeySet();
        pool.forEach(10, piece -> seen.add(Thread.currentThread()));
        assertEquals(Set.of(Thread.currentThread()), seen);
    }

    /** The helper threads sleep between some of the rounds and are awake between others. */
    @Test
    public void sharingAllocatesNothing() {
        threads(2);
        AtomicIntegerArray done = new AtomicIntegerArray(4);
        IntConsumer piece = done::incrementAndGet;
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long least = Long.MAX_VALUE;
        for (int round = 0; round < MOST_ROUNDS && least > 0; round++) {
            long before = threads.getThreadAllocatedBytes(id);
            for (int i = 0; i < 100; i++) {
                pool.forEach(4, piece);
                if (i % 10 == 0) {
                    LockSupport.parkNanos(200_000);
                }
            }
            least = Math.min(least, threads.getThreadAllocatedBytes(id) - before);
        }
        assertEquals(0, least);
        assertFalse(done.get(0) == 0);
    }

    @Test
    public void anIllegalNumberOfThreadsIsReportedWithTheLegalRange() {
        for (int threads : new int[] {0, -1, 257}) {
            assertEquals("threads is " + threads + ", legal: 1 to 256",
                assertThrows(IllegalArgumentException.class, () -> pool.setThreads(threads)).getMessage());
        }
        pool.setThreads(256);
        assertEquals(256, pool.getThreads());
    }
}
