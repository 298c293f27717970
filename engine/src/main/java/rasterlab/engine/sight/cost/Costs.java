package rasterlab.engine.sight.cost;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;

/**
 * The measured cost of one unit of each kind of work: {@code frame + Σ nᵢ·cᵢ}, n counted, c from
 * the table that ships with the engine and names its machine, day and method.
 */
public final class Costs {
    /** Stands for what a picture costs whatever is on it. */
    private static final String FRAME = "frame";

    /** The work that the pipeline does on all cores. */
    private static final Set<String> PARALLEL =
            Set.of("fragments", "pixel-lights", "texels", "pixels");

    /** How much of another core is gained. */
    private static final double SHARED = 0.7;

    private final Properties table;

    private Costs(Properties table) {
        this.table = table;
    }

    /** The measured table. */
    public static Costs measured() {
        try (InputStream in = Costs.class.getResourceAsStream("costs.properties")) {
            var table = new Properties();
            table.load(new InputStreamReader(in, StandardCharsets.UTF_8));
            return new Costs(table);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A table with these prices instead, measured on this machine now. */
    public Costs with(List<String> lines) {
        var here = new Properties();
        here.setProperty("method", table.getProperty("method"));
        here.setProperty("machine", "this machine");
        here.setProperty("date", "now");
        for (String line : lines) {
            int equals = line.indexOf('=');
            here.setProperty(line.substring(0, equals), line.substring(equals + 1));
        }
        return new Costs(here);
    }

    /** Where the numbers come from. */
    public String origin() {
        return table.getProperty("method")
                + "; "
                + table.getProperty("machine")
                + ", "
                + table.getProperty("date");
    }

    /** Milliseconds of processor time of each stage, in the order of {@link PictureWork#stages}. */
    public Map<String, Double> stages(Family family, PictureWork work) {
        var stages = new LinkedHashMap<String, Double>();
        stages.put(FRAME, price(family, FRAME) / 1e6);
        work.stages().forEach((stage, n) -> stages.put(stage, n * price(family, stage) / 1e6));
        return stages;
    }

    /**
     * Milliseconds until a picture is done.
     *
     * @param cores that a family shares its work among, where it can
     */
    public double milliseconds(Family family, PictureWork work, int cores) {
        double sum = 0;
        double team = family == Family.PIPELINE ? Math.max(1, SHARED * cores) : 1;
        for (Map.Entry<String, Double> stage : stages(family, work).entrySet())
            sum += stage.getValue() / (PARALLEL.contains(stage.getKey()) ? team : 1);
        return sum;
    }

    /** Nanoseconds for one. */
    private double price(Family family, String stage) {
        return Double.parseDouble(table.getProperty(family.code() + "." + stage, "0"));
    }
}
