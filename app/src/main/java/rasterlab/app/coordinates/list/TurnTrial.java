package rasterlab.app.coordinates.list;

import java.util.Arrays;
import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.axis.AxisTurn;

/** Points that turn about a line. */
final class TurnTrial extends ImagesTrial<AxisRotation, AxisTurn> {
    TurnTrial(OwnMethods own) {
        super(own.in(new AxisTopic()));
    }

    @Override
    PointList list(AxisTurn turn) {
        return PointList.of(turn);
    }

    @Override
    Optional<AxisTurn> listed(ListScene scene) {
        double[] points = scene.choice().coordinates();
        return scene.choice()
                .only(PointList.TURN)
                .map(
                        n ->
                                new AxisTurn(
                                        Arrays.copyOf(n, 3),
                                        Arrays.copyOfRange(n, 3, 6),
                                        n[6],
                                        points));
    }

    @Override
    AxisTurn only(AxisTurn turn, int point) {
        return new AxisTurn(
                turn.through(), turn.direction(), turn.degrees(), xyz(turn.points(), point));
    }
}
