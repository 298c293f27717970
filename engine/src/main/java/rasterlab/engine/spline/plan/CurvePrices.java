package rasterlab.engine.spline.plan;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Properties;

/** The prices of flattening curves and drawing polylines, in nanoseconds of processor time. */
public final class CurvePrices {
    /** The methods with prices: those whose polylines are always within the flatness. */
    public static final List<String> METHODS = List.of("uniform", "adaptive", "fewest");

    private final Properties table;

    private CurvePrices(Properties table) {
        this.table = table;
    }

    /** The measured table that ships with the engine. */
    public static CurvePrices measured() {
        try (InputStream in = CurvePrices.class.getResourceAsStream("curve-prices.properties")) {
            var table = new Properties();
            table.load(new InputStreamReader(in, StandardCharsets.UTF_8));
            return new CurvePrices(table);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Where the numbers come from. */
    public String origin() {
        return table.getProperty("method")
                + "; "
                + table.getProperty("machine")
                + ", "
                + table.getProperty("date");
    }

    /** Nanoseconds in which a method makes the polylines of curves. */
    double flattening(String method, int curves, long segments) {
        return curves * price(method + ".curve") + segments * price(method + ".segment");
    }

    /** Nanoseconds in which segments are drawn, without their pixels: these are as many anyway. */
    double drawing(long segments) {
        return segments * price("draw.segment");
    }

    private double price(String key) {
        return Double.parseDouble(table.getProperty(key));
    }
}
