package rasterlab.app.coordinates.list;

import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.EyeView;
import rasterlab.engine.transform.view.ViewTask;
import rasterlab.engine.transform.view.ViewTopic;

/** Points as an eye on a sphere sees them. */
final class LookTrial extends ImagesTrial<EyeView, ViewTask> {
    LookTrial(OwnMethods own) {
        super(own.in(new ViewTopic()));
    }

    @Override
    PointList list(ViewTask look) {
        return PointList.of(look);
    }

    @Override
    Optional<ViewTask> listed(ListScene scene) {
        double[] points = scene.choice().coordinates();
        return scene.choice().only(PointList.VIEW).map(n -> new ViewTask(n[0], n[1], n[2], points));
    }

    @Override
    ViewTask only(ViewTask look, int point) {
        return new ViewTask(look.theta(), look.phi(), look.rho(), xyz(look.points(), point));
    }
}
