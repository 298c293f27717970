package rasterlab.app.polygon.outcome;

import java.util.List;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.polygon.figure.CornerList;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.contract.PointInPolygon;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.fill.FillTask;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.fill.TracedFill;
import rasterlab.engine.naming.Named;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.polygon.inside.PointInPolygonTopic;
import rasterlab.engine.polygon.inside.SteppedPolygonTest;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.polygon.scan.PolygonTask;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.engine.polygon.triangle.SteppedTriangleTest;
import rasterlab.engine.polygon.triangulation.SteppedTriangulator;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** The engine's topics that the lab shows, one for each mode. */
public record PolygonTopics(
        PointInTriangleTopic triangle,
        PointInPolygonTopic polygon,
        TriangulateTopic triangulation,
        PolygonFillTopic fill,
        FillTopic seed,
        OwnMethods own) {
    /** The lab of somebody who has written no program. */
    public PolygonTopics() {
        this(new OwnMethods());
    }

    public PolygonTopics(OwnMethods own) {
        this(
                new PointInTriangleTopic(),
                new PointInPolygonTopic(),
                new TriangulateTopic(),
                new PolygonFillTopic(),
                new FillTopic(),
                own);
    }

    Topic<?, ?, ?> of(PolygonMode mode) {
        return switch (mode) {
            case TRIANGLE -> triangle;
            case POLYGON -> polygon;
            case TRIANGULATION -> triangulation;
            case FILL -> fill;
            case SEED -> seed;
        };
    }

    public List<String> methods(PolygonMode mode) {
        return of(mode).methods().stream().map(Method::name).toList();
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public Method<?> method(PolygonMode mode, String name) {
        return own.method(of(mode), name);
    }

    public List<? extends Hazard<?>> hazards(PolygonMode mode) {
        return of(mode).hazards();
    }

    /**
     * The figure with a hazard's input in the place of its own.
     *
     * @throws IllegalArgumentException naming the hazards there are
     */
    public PolygonFigure showing(PolygonScene scene, String hazard) {
        Object input =
                Named.<Hazard<?>>find(
                                "hazard", hazard, List.copyOf(hazards(scene.mode())), Hazard::name)
                        .input();
        return showing(scene.figure(), input);
    }

    /** The figure with another input of its topic in the place of its own. */
    public static PolygonFigure showing(PolygonFigure figure, Object input) {
        if (figure instanceof InsideFigure old) return old.showing((ShapeAndPoints) input);
        if (figure instanceof CutFigure) return new CutFigure(CornerList.of((Points) input));
        if (figure instanceof FillFigure old) return old.showing((PolygonTask) input);
        return ((SeedFigure) figure).showing((FillTask) input);
    }

    /**
     * The judge of points by that method of one of the modes that judge.
     *
     * @param corners three for a triangle
     */
    public Membership.PointClassifier judge(PolygonMode mode, String method, Points corners) {
        Membership.PointClassifier judge = anyJudge(mode, method, corners);
        return method.equals(OwnMethods.NAME) ? new StoppedJudge(judge) : judge;
    }

    private Membership.PointClassifier anyJudge(PolygonMode mode, String method, Points corners) {
        if (mode == PolygonMode.POLYGON) {
            PointInPolygon test = own.method(polygon, method).implementation();
            double[] polygonX = corners.xs();
            double[] polygonY = corners.ys();
            return (x, y) -> test.contains(polygonX, polygonY, x, y);
        }
        PointInTriangle test = own.method(triangle, method).implementation();
        double[] cornerX = corners.xs();
        double[] cornerY = corners.ys();
        return (x, y) ->
                test.contains(
                        cornerX[0],
                        cornerY[0],
                        cornerX[1],
                        cornerY[1],
                        cornerX[2],
                        cornerY[2],
                        x,
                        y);
    }

    /** The decision of a method's steps, as a formula or in words; "" for one without steps. */
    public static String decisionFormula(Method<?> method) {
        Object implementation = method.implementation();
        if (implementation instanceof SteppedTriangleTest test) return test.valueFormula();
        if (implementation instanceof SteppedPolygonTest test) return test.countFormula();
        if (implementation instanceof SteppedTriangulator cutter) return cutter.choice();
        return implementation instanceof TracedFill fill ? fill.waitingMeans() : "";
    }
}
