package rasterlab.app.coordinates.list;

import java.util.Optional;
import rasterlab.app.coordinates.figure.CallJson;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.axis.AxisTurn;

/** Points that turn about a line. */
final class TurnTrial extends TrialKind<AxisRotation, AxisTurn, Images> {
    TurnTrial() {
        super(new AxisTopic(), new TrialTexts("coordinates.list", "rotate-axis."));
    }

    @Override
    PointList list(AxisTurn turn) {
        return PointList.of(turn);
    }

    @Override
    Images images(Images output) {
        return output;
    }

    @Override
    Optional<double[]> h(Images output) {
        return Optional.empty();
    }

    @Override
    AxisTurn only(AxisTurn turn, int point) {
        return new AxisTurn(
                turn.through(), turn.direction(), turn.degrees(), xyz(turn.points(), point));
    }

    @Override
    Images outputOf(Images output, int point) {
        return new Images(xyz(output.coordinates(), point), 3);
    }

    @Override
    String json(AxisTurn turn) {
        return "{\"points\": %s, \"through\": %s, \"direction\": %s, \"degrees\": %s}"
                .formatted(
                        CallJson.points(3, turn.points()),
                        CallJson.list(turn.through()),
                        CallJson.list(turn.direction()),
                        CallJson.number(turn.degrees()));
    }
}
