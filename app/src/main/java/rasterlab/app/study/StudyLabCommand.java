package rasterlab.app.study;

import rasterlab.app.language.Language;

/** The shell command that measures what the tab shows. */
final class StudyLabCommand {
    private StudyLabCommand() {}

    static String of(StudyLabState state, Language language) {
        String topic = state.topic().name();
        if (state.view() == StudyView.HAZARDS) return "./lab hazards " + topic;
        StudyCost cost = state.view().cost().orElseThrow();
        return "./lab study %s%s%s%s --out study-%s.svg"
                .formatted(
                        topic,
                        cost == StudyCost.TIME ? "" : " --cost " + cost.code(),
                        state.thorough() ? "" : " --quick",
                        language == Language.RUSSIAN ? " --lang ru" : "",
                        topic);
    }
}
