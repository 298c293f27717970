/**
 * Watches the event thread while tests run: what must never keep it fails the test, whatever else
 * keeps it for longer than 50 ms is printed when the class is done.
 *
 * <p>Found by JUnit for every test class of this module. Start with {@link
 * rasterlab.tests.watchdog.EventWatchdog}; what is blamed is told by {@link
 * rasterlab.tests.watchdog.Blame}.
 */
package rasterlab.tests.watchdog;
