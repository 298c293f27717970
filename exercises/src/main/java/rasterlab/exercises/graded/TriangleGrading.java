package rasterlab.exercises.graded;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.exercises.drawing.PlaneFigure;
import rasterlab.exercises.drawing.PlanePictures;
import rasterlab.exercises.drawing.YAxis;
import rasterlab.exercises.judging.ByTopic;
import rasterlab.exercises.score.CasePicture;

/** Grades the topic {@code point-in-triangle}; draws the points that are judged inside. */
public final class TriangleGrading extends ByTopic<PointInTriangle, ShapeAndPoints, Membership> {
    public TriangleGrading() {
        super(new PointInTriangleTopic(), new PlainTriangle());
    }

    @Override
    protected List<CasePicture> pictures(
            ShapeAndPoints input, Membership exact, Membership actual) {
        return PlanePictures.of(
                List.of(PlaneFigure.polygon(input.corners().numbers())),
                inside(input.points(), exact),
                inside(input.points(), actual),
                0,
                YAxis.UP);
    }

    private static List<PlaneFigure> inside(Points points, Membership judged) {
        var inside = new ArrayList<PlaneFigure>();
        for (int i = 0; i < judged.size(); i++)
            if (judged.inside(i)) inside.add(PlaneFigure.point(points.x(i), points.y(i)));
        return inside;
    }
}
