package rasterlab.app.coordinates.list;

import java.util.Optional;
import rasterlab.app.coordinates.figure.CallJson;
import rasterlab.contract.EyeView;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.view.Look;
import rasterlab.engine.transform.view.ViewTopic;

/** Points as an eye on a sphere sees them. */
final class LookTrial extends TrialKind<EyeView, Look, Images> {
    LookTrial() {
        super(new ViewTopic(), new TrialTexts("coordinates.list", "view."));
    }

    @Override
    PointList list(Look look) {
        return PointList.of(look);
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
    Look only(Look look, int point) {
        return new Look(look.theta(), look.phi(), look.rho(), xyz(look.points(), point));
    }

    @Override
    Images outputOf(Images output, int point) {
        return new Images(xyz(output.coordinates(), point), 3);
    }

    @Override
    String json(Look look) {
        return "{\"points\": %s, \"theta\": %s, \"phi\": %s, \"rho\": %s}"
                .formatted(
                        CallJson.points(3, look.points()),
                        CallJson.number(look.theta()),
                        CallJson.number(look.phi()),
                        CallJson.number(look.rho()));
    }
}
