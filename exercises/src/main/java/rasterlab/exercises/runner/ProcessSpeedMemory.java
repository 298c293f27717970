package rasterlab.exercises.runner;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalInt;

/** The sources that were graded last in this process. */
final class ProcessSpeedMemory implements SpeedMemory {
    private static final int MOST = 4096;

    private final Map<String, Integer> bands =
            new LinkedHashMap<>() {
                private static final long serialVersionUID = 1L;

                @Override
                protected boolean removeEldestEntry(Map.Entry<String, Integer> eldest) {
                    return size() > MOST;
                }
            };

    @Override
    public synchronized OptionalInt band(String key) {
        Integer known = bands.get(key);
        return known == null ? OptionalInt.empty() : OptionalInt.of(known);
    }

    @Override
    public synchronized void keep(String key, int band) {
        bands.put(key, band);
    }
}
