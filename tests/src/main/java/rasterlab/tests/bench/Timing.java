package rasterlab.tests.bench;

import java.util.Map;
import java.util.TreeMap;
import org.openjdk.jmh.results.RunResult;

/**
 * Time of one operation over the iterations of one benchmark, in nanoseconds.
 *
 * @param low first quartile
 * @param high third quartile
 */
record Timing(double median, double low, double high) {
    /** Which benchmark, at which values of its parameters. */
    record Key(String benchmark, Map<String, String> parameters) {
        Key {
            parameters = Map.copyOf(parameters);
        }

        static Key of(Class<?> benchmark, String method, Map<String, String> parameters) {
            return new Key(benchmark.getName() + "." + method, parameters);
        }
    }

    static Key key(RunResult result) {
        var parameters = new TreeMap<String, String>();
        for (String name : result.getParams().getParamsKeys())
            parameters.put(name, result.getParams().getParam(name));
        return new Key(result.getParams().getBenchmark(), parameters);
    }

    static Timing of(RunResult result) {
        var statistics = result.getPrimaryResult().getStatistics();
        return new Timing(
                statistics.getPercentile(50),
                statistics.getPercentile(25),
                statistics.getPercentile(75));
    }
}
