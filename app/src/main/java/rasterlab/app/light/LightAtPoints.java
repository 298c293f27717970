package rasterlab.app.light;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.visibility.SeenPoint;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The light of all lamps at points of a body, by the user's program on a topic or as is right
 * there.
 *
 * <p>Methods know one lamp. What they find for each is added up: emission and ambient light are
 * asked for with the first. Three shares of each point, one after the other.
 */
interface LightAtPoints {
    /** A lamp so far away that a scene's points see it in one direction. */
    double FAR = 1e12;

    /**
     * How a body is lit by methods of the choice's topic.
     *
     * @param view the body as the eye sees it
     */
    static LightAtPoints of(LightChoice choice, ViewedMesh view) {
        return choice.shaded().equals(LightOfPoints.TOPIC)
                ? new LightOfPoints(choice, view.transform())
                : new LightOfFaces(choice, view.mesh(), view.transform());
    }

    /** The program can be asked for so many points while something is dragged. */
    int most();

    /**
     * The right light.
     *
     * @param own whose program's exercise may call another method right than the topic does
     */
    double[] right(OwnMethods own, List<SeenPoint> points, BooleanSupplier cancelled);

    /**
     * The light by the user's program.
     *
     * @throws IllegalArgumentException when it gives no answer, or refuses
     * @throws CancellationException soon after {@code cancelled} says true
     */
    double[] by(OwnMethods own, List<SeenPoint> points, BooleanSupplier cancelled);

    /** The lamps that shine; a dark one where none does, since methods ask for one. */
    static List<Lamp> shining(LightChoice choice) {
        List<Lamp> on = choice.lamps().stream().filter(Lamp::on).toList();
        return on.isEmpty() ? List.of(choice.lamp()) : on;
    }

    /** Returns the light that a lamp sends out: none where it is off. */
    static LightSource source(Lamp lamp) {
        double[] none = new double[3];
        return lamp.on()
                ? lamp.light().source()
                : new LightSource(none, none, none, Attenuation.none(), SpotCone.none());
    }

    /** The material as it is lit by a lamp of that number, of which the first lets it glow too. */
    static SurfaceMaterial material(LightChoice choice, int lamp) {
        SurfaceMaterial whole =
                LightTerm.only(choice.terms(), choice.material().material()).surface();
        return lamp == 0
                ? whole
                : new SurfaceMaterial(
                        whole.ambient(),
                        whole.diffuse(),
                        whole.specular(),
                        new double[3],
                        whole.shininess());
    }

    /** Light from everywhere, which comes with the first lamp. */
    static double[] globalAmbient(LightChoice choice, int lamp) {
        return lamp == 0 ? choice.model().globalAmbient() : new double[3];
    }

    static void check(BooleanSupplier cancelled) {
        if (cancelled.getAsBoolean()) throw new CancellationException();
    }
}
