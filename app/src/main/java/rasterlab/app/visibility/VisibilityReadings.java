package rasterlab.app.visibility;

import java.text.NumberFormat;
import java.util.function.Function;
import rasterlab.app.language.Texts;
import rasterlab.engine.raster.PictureDifference;

/** The live numbers of a state as the inspector writes them. */
final class VisibilityReadings {
    private final VisibilityLabState state;
    private final Texts texts;

    VisibilityReadings(VisibilityLabState state, Texts texts) {
        this.state = state;
        this.texts = texts;
    }

    String theta() {
        return angle(state.choice().camera().thetaRadians());
    }

    /** θ as a multiple of π. */
    String thetaOfPi() {
        return number(state.choice().camera().thetaRadians() / Math.PI, 2);
    }

    String phi() {
        return angle(state.choice().camera().phiRadians());
    }

    String rho() {
        return number(state.choice().camera().rho(), 1);
    }

    String zoom() {
        return "× " + number(state.choice().zoom(), 2);
    }

    String size() {
        return state.picture()
                .map(picture -> picture.raster().width() + " × " + picture.raster().height())
                .orElse("–");
    }

    String frameTime() {
        if (state.medianNanos() == 0) return texts.text("frameTime.none");
        return texts.text("frameTime.millis", number(state.medianNanos() / 1e6, 1));
    }

    String wrongPixels() {
        return compared(difference -> texts.text("wrongPixels.count", difference.wrongPixels()));
    }

    String share() {
        return compared(
                difference -> texts.text("share.percent", number(100 * difference.share(), 3)));
    }

    String largest() {
        return compared(
                difference -> texts.text("largest.levels", difference.largestLevelDifference()));
    }

    private String compared(Function<PictureDifference, String> reading) {
        if (!state.choice().difference()) return "–";
        return state.difference().map(reading).orElseGet(() -> texts.text("comparing"));
    }

    /** Radians, and the same as a multiple of π. */
    private String angle(double radians) {
        return texts.text("angle", number(radians, 3), number(radians / Math.PI, 3));
    }

    private String number(double value, int decimals) {
        NumberFormat format = NumberFormat.getInstance(texts.locale());
        format.setMinimumFractionDigits(decimals);
        format.setMaximumFractionDigits(decimals);
        return format.format(value).replace('-', '−');
    }
}
