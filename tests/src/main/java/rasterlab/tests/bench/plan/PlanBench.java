package rasterlab.tests.bench.plan;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.plan.BruteForce;
import rasterlab.engine.plan.Combination;
import rasterlab.engine.plan.PlanPath;
import rasterlab.engine.plan.PlanTrial;
import rasterlab.engine.plan.Planner;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.transform.SphericalView;
import rasterlab.tests.bench.language.BenchWords;

/**
 * Draws plans of seeded scenes, cameras, sizes and tolerances, and prints how their errors and
 * costs are spread; beside each measured ratio stands the predicted one.
 *
 * <p>Costs are processor time of one thread, the least of several rounds: other programs on the
 * machine hardly change it.
 */
public final class PlanBench {
    private static final int ROUNDS = 12;
    private static final int MANY = 500;
    private static final int FEW = 40;
    private static final long SEED = 32;

    /** Pictures of a camera's path, along which plans are kept. */
    private static final int PICTURES = 100;

    /** Rounds of such a path, each by a planner that knows nothing; the least counts. */
    private static final int PATHS = 4;

    /** Bytes of heap in which 10⁶ faces and two pictures' working memory have room. */
    private static final long ROOM = 3L << 30;

    /** Each so many combinations all ways are tried too. */
    private static final int PROVED = 5;

    private final boolean quick;
    private final BenchWords words;
    private final PrintStream out;
    private final List<Double> costs = new ArrayList<>();

    /** Where a plan leaves nothing out, both pictures are one: what differs is the machine's. */
    private final List<Double> noise = new ArrayList<>();

    private final List<Double> againstCheapest = new ArrayList<>();
    private final List<Double> first = new ArrayList<>();
    private final List<Double> deciding = new ArrayList<>();
    private int outside;
    private int steppedBack;

    public PlanBench(boolean quick, BenchWords words, PrintStream out) {
        this.quick = quick;
        this.words = words;
        this.out = out;
    }

    /** Prints a line for each combination, then the distribution. */
    public void run() {
        var random = new Random(SEED);
        var planner = new Planner(1, Costs.measured());
        for (int k = 0; k < (quick ? FEW : MANY); k++) tryOne(planner, random, k);
        print("plan.outside", outside, costs.size());
        print("plan.back", steppedBack, costs.size());
        spread("plan.costs", costs);
        spread("plan.noise", noise);
        print("plan.dearer", costs.stream().filter(c -> c > 1.03).count(), costs.size());
        spread("plan.cheapest", againstCheapest);
        spread("plan.first", first);
        spread("plan.deciding", deciding);
        print("plan.slow", deciding.stream().filter(d -> d > 0.03).count(), deciding.size());
    }

    private void tryOne(Planner planner, Random random, int k) {
        Scene scene = scene(random);
        SphericalView usual = scene.defaultCamera();
        var camera =
                new SphericalView(
                        2 * Math.PI * random.nextDouble(),
                        0.2 + 2.7 * random.nextDouble(),
                        usual.rho() * (0.6 + 1.5 * random.nextDouble()));
        int width = 80 + random.nextInt(400);
        var tolerance =
                new Tolerance(0.1 * Math.pow(50, random.nextDouble()), 1 + random.nextInt(8), 0);
        var asked =
                new RenderRequest(
                        scene, "pipeline", "phong", "perspective", camera, width, width * 3 / 4);
        PlanTrial trial = PlanTrial.of(planner, asked, tolerance, ROUNDS, () -> false);
        if (!trial.error().within(tolerance)) outside++;
        if (trial.steppedBack() > 0) steppedBack++;
        double ratio = trial.processor() / trial.fullProcessor();
        if (!trial.plan().saves()) noise.add(ratio);
        double cost = trial.plan().saves() ? ratio : 1;
        costs.add(cost);
        decide(asked, tolerance, trial.fullProcessor());
        String cheapest = "";
        if (k % PROVED == 0 && scene.mesh().faceCount() < 4000) {
            List<Combination> ways =
                    BruteForce.within(trial.plan(), trial.full(), tolerance, 4, () -> false);
            if (!ways.isEmpty()) {
                againstCheapest.add(trial.processor() / ways.get(0).processor());
                cheapest = ways.get(0).name();
            }
        }
        out.printf(
                Locale.ROOT,
                "%s %d %d×%d %.2f px %.0f: %.0f, %d; %.3f (%.3f); %s%n",
                scene.name(),
                scene.mesh().faceCount(),
                asked.width(),
                asked.height(),
                tolerance.pixels(),
                tolerance.levels(),
                trial.error().levels(),
                trial.error().wrong(),
                cost,
                trial.plan().cost().milliseconds() / trial.plan().fullCost().milliseconds(),
                cheapest);
    }

    /** Deciding against a full picture: the first time, and for each picture of a path. */
    private void decide(RenderRequest asked, Tolerance tolerance, double full) {
        double atFirst = Double.POSITIVE_INFINITY;
        double each = Double.POSITIVE_INFINITY;
        for (int k = 0; k < PATHS; k++) {
            var path = PlanPath.of(new Planner(1, Costs.measured()), asked, tolerance, PICTURES);
            atFirst = Math.min(atFirst, path.firstMilliseconds());
            each = Math.min(each, path.perPicture());
        }
        first.add(atFirst / full);
        deciding.add(each / full);
    }

    /**
     * A random scene; those made in steps have 10² to 10⁶ faces, or to 10⁵ where memory is little.
     */
    private Scene scene(Random random) {
        List<String> names = Scenes.names();
        String name = names.get(random.nextInt(names.size()));
        if (!Scenes.namesWithDetail().contains(name) || random.nextInt(3) == 0)
            return Scenes.named(name);
        int doubled = quick || Runtime.getRuntime().maxMemory() < ROOM ? 5 : 7;
        return Scenes.named(name, (int) Math.round(8 * Math.pow(2, doubled * random.nextDouble())));
    }

    private void print(String key, long count, int of) {
        out.println(words.text(key, Long.toString(count), Integer.toString(of)));
    }

    private void spread(String key, List<Double> values) {
        if (values.isEmpty()) return;
        Collections.sort(values);
        int last = values.size() - 1;
        var shown = new ArrayList<String>();
        for (double share : new double[] {0, 0.25, 0.5, 0.75, 0.95, 1})
            shown.add(String.format(Locale.ROOT, "%.3f", values.get((int) (share * last))));
        out.println(words.text(key, String.join("  ", shown)));
    }
}
