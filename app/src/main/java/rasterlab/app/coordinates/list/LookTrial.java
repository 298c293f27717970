package rasterlab.app.coordinates.list;

import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.EyeView;
import rasterlab.engine.transform.view.Look;
import rasterlab.engine.transform.view.ViewTopic;

/** Points as an eye on a sphere sees them. */
final class LookTrial extends ImagesTrial<EyeView, Look> {
    LookTrial(OwnMethods own) {
        super(own.in(new ViewTopic()));
    }

    @Override
    PointList list(Look look) {
        return PointList.of(look);
    }

    @Override
    Optional<Look> listed(ListScene scene) {
        double[] points = scene.choice().coordinates();
        return scene.choice().only(PointList.VIEW).map(n -> new Look(n[0], n[1], n[2], points));
    }

    @Override
    Look only(Look look, int point) {
        return new Look(look.theta(), look.phi(), look.rho(), xyz(look.points(), point));
    }
}
