package rasterlab.tests.watchdog;

/**
 * The report on an event that kept the event thread for long. It does not hold the event, whose
 * source may be a window that a test wants to see let go.
 *
 * @param name the event's
 * @param nanos from its begin to its end
 * @param place where the thread was seen most often
 */
record LongStay(String name, long nanos, String place) {}
