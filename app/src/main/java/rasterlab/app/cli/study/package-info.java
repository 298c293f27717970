/**
 * The commands that compare methods: {@code methods} lists them, {@code hazards} tries them on
 * hazards, {@code study} measures them, {@code chart} draws. Start reading at {@link
 * rasterlab.app.cli.study.StudyCommand}.
 */
package rasterlab.app.cli.study;
