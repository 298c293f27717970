package rasterlab.app.coordinates.list;

import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.axis.AxisTurn;

/** Points that turn about a line. */
final class TurnTrial extends ImagesTrial<AxisRotation, AxisTurn> {
    TurnTrial(OwnMethods own) {
        super(own.in(new AxisTopic()), "rotate-axis.");
    }

    @Override
    PointList list(AxisTurn turn) {
        return PointList.of(turn);
    }

    @Override
    AxisTurn only(AxisTurn turn, int point) {
        return new AxisTurn(
                turn.through(), turn.direction(), turn.degrees(), xyz(turn.points(), point));
    }
}
