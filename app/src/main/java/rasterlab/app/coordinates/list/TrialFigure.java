package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkInk;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.language.Language;
import rasterlab.engine.raster.PixelMark;

/**
 * Where a hazard's points belong, as crosses, and where the method has them, as dots of its colour.
 * A ring is around a point that the method misses, a saltire over one that has no image, and a
 * dashed line leads to one that is elsewhere.
 */
final class TrialFigure {
    private final TrialScene scene;
    private final ListPlaces places;
    private final List<Mark> marks = new ArrayList<>();

    /** How the method is called. */
    private final String called;

    private TrialFigure(TrialScene scene, ListChoice choice, Language language) {
        this.scene = scene;
        called = OwnWords.called(scene.trial().method(), language);
        places = new ListPlaces(choice);
    }

    /**
     * @param choice from where space is looked at
     */
    static Figure of(TrialScene scene, ListChoice choice, Language language) {
        var figure = new TrialFigure(scene, choice, language);
        figure.marks.addAll(figure.places.axes(scene.reach()));
        figure.given();
        scene.made().ifPresent(figure::made);
        for (StagePoint spot : figure.places.of(scene.exact().points()))
            if (spot.isFinite()) figure.marks.add(new Mark.CrossMark(spot, MarkInk.OBJECT, ""));
        return new Figure(figure.marks, false);
    }

    /** A dotted line leads from where a point is given to where it belongs. */
    private void given() {
        List<StagePoint> spots = places.of(scene.given());
        List<StagePoint> right = places.of(scene.exact().points());
        for (int i = 0; i < spots.size(); i++) {
            if (!scene.inReach(scene.given(), i)) continue;
            marks.add(new Mark.LineMark(spots.get(i), right.get(i), MarkInk.GHOST));
            marks.add(new Mark.DotMark(spots.get(i), MarkInk.GHOST, ""));
        }
    }

    private void made(TrialScene.TrialPoints made) {
        List<StagePoint> right = places.of(scene.exact().points());
        List<StagePoint> spots = places.of(made.points());
        MarkInk ink = MarkInk.method(scene.trial().method());
        boolean named = false;
        for (int i = 0; i < scene.fates().size(); i++) {
            TrialScene.Fate fate = scene.fates().get(i);
            boolean shown = spots.get(i).isFinite() && scene.inReach(made.points(), i);
            if (fate == TrialScene.Fate.MISSING)
                marks.add(new Mark.WrongMark(right.get(i), PixelMark.MISSING));
            if (!shown) continue;
            if (fate == TrialScene.Fate.WRONG)
                marks.add(new Mark.LineMark(right.get(i), spots.get(i), MarkInk.PRINTED));
            boolean label = !named && fate != TrialScene.Fate.RIGHT;
            named |= label;
            marks.add(new Mark.DotMark(spots.get(i), ink, label ? called : ""));
            if (fate == TrialScene.Fate.EXTRA)
                marks.add(new Mark.WrongMark(spots.get(i), PixelMark.EXTRA));
        }
    }
}
