// Written by ios/tools/words.py from the texts of both apps. Never by hand.
import Foundation

/// Everything that the app says itself, in the language of the phone.
enum Words {
  private static func plain(_ key: String) -> String { Bundle.main.localizedString(forKey: key, value: nil, table: nil) }

  private static func filled(_ key: String, _ places: any CVarArg...) -> String {
    String(format: plain(key), locale: .current, arguments: places)
  }

  static var about: String { plain("about") }
  static var aboutSays: String { plain("about_says") }
  static var accNoise: String { plain("acc_noise") }
  static var accelerometer: String { plain("accelerometer") }
  static var actionAccept: String { plain("action_accept") }
  static var actionBegin: String { plain("action_begin") }
  static var actionContinue: String { plain("action_continue") }
  static var actionKeep: String { plain("action_keep") }
  static var actionMeasured: String { plain("action_measured") }
  static var actionReopen: String { plain("action_reopen") }
  static var actionRepeat: String { plain("action_repeat") }
  static var actionRetry: String { plain("action_retry") }
  static var actionSetReference: String { plain("action_set_reference") }
  static var actionSkip: String { plain("action_skip") }
  static var actionStartRecording: String { plain("action_start_recording") }
  static var actionStopRecording: String { plain("action_stop_recording") }
  static var actionWorkAgain: String { plain("action_work_again") }
  static var amplitude: String { plain("amplitude") }
  static var armM: String { plain("arm_m") }
  static var atHand: String { plain("at_hand") }
  static var axisHeightM: String { plain("axis_height_m") }
  static var back: String { plain("back") }
  static func beat(_ first: Double) -> String { filled("beat", first) }
  static var beatNone: String { plain("beat_none") }
  static var boat: String { plain("boat") }
  static var boatBeam: String { plain("boat_beam") }
  static var boatLength: String { plain("boat_length") }
  static var boatMass: String { plain("boat_mass") }
  static var boatName: String { plain("boat_name") }
  static var bow: String { plain("bow") }
  static var bowDown: String { plain("bow_down") }
  static var bowUp: String { plain("bow_up") }
  static var budget: String { plain("budget") }
  static func causeProbability(_ first: String, _ second: Double) -> String { filled("cause_probability", first, second) }
  static var causes: String { plain("causes") }
  static var certainEnough: String { plain("certain_enough") }
  static func certainIn(_ first: Double) -> String { filled("certain_in", first) }
  static var certainNever: String { plain("certain_never") }
  static var classLimits: String { plain("class_limits") }
  static var classLimitsSays: String { plain("class_limits_says") }
  static var close: String { plain("close") }
  static var comparedSays: String { plain("compared_says") }
  static func comparedSwing(_ first: String) -> String { filled("compared_swing", first) }
  static var consistency: String { plain("consistency") }
  static func contribution(_ first: Double, _ second: String) -> String { filled("contribution", first, second) }
  static var criticise: String { plain("criticise") }
  static var criticiseSays: String { plain("criticise_says") }
  static var criticism: String { plain("criticism") }
  static var cueDone: String { plain("cue_done") }
  static var cueGood: String { plain("cue_good") }
  static var cueRecording: String { plain("cue_recording") }
  static var cueRelease: String { plain("cue_release") }
  static var cueRepeat: String { plain("cue_repeat") }
  static var cueTouched: String { plain("cue_touched") }
  static var cues: String { plain("cues") }
  static var curveBase: String { plain("curve_base") }
  static var curveExtended: String { plain("curve_extended") }
  static var curveFit: String { plain("curve_fit") }
  static var curveMeasured: String { plain("curve_measured") }
  static var curveResidual: String { plain("curve_residual") }
  static var decayS: String { plain("decay_s") }
  static func degrees(_ first: Double) -> String { filled("degrees", first) }
  static func degreesOf(_ first: Double, _ second: Double) -> String { filled("degrees_of", first, second) }
  static func degreesU(_ first: String, _ second: String) -> String { filled("degrees_u", first, second) }
  static func degreesWhole(_ first: Double) -> String { filled("degrees_whole", first) }
  static var depthM: String { plain("depth_m") }
  static var discrepancies: String { plain("discrepancies") }
  static var diskFull: String { plain("disk_full") }
  static var doneSays: String { plain("done_says") }
  static var effort: String { plain("effort") }
  static var ellipsoid: String { plain("ellipsoid") }
  static var ellipsoidSays: String { plain("ellipsoid_says") }
  static var expected: String { plain("expected") }
  static var fileNotMade: String { plain("file_not_made") }
  static var finer: String { plain("finer") }
  static var fitSays: String { plain("fit_says") }
  static func framePoints(_ first: String, _ second: String) -> String { filled("frame_points", first, second) }
  static func fromTo(_ first: String, _ second: String, _ third: String) -> String { filled("from_to", first, second, third) }
  static func gapOne(_ first: Double, _ second: String, _ third: Double) -> String { filled("gap_one", first, second, third) }
  static var gaps: String { plain("gaps") }
  static func gapsMore(_ first: Int) -> String { filled("gaps_more", first) }
  static var gapsSay: String { plain("gaps_say") }
  static var gravity: String { plain("gravity") }
  static var gravityMS2: String { plain("gravity_m_s2") }
  static var gyroNoise: String { plain("gyro_noise") }
  static var gyroscope: String { plain("gyroscope") }
  static var haptics: String { plain("haptics") }
  static var help: String { plain("help") }
  static var helpFailed: String { plain("help_failed") }
  static var helpHang: String { plain("help_hang") }
  static var helpInterrupted: String { plain("help_interrupted") }
  static var helpJudge: String { plain("help_judge") }
  static var helpLevel: String { plain("help_level") }
  static var helpReady: String { plain("help_ready") }
  static var helpRecord: String { plain("help_record") }
  static var helpRest: String { plain("help_rest") }
  static var helpResult: String { plain("help_result") }
  static var helpSetup: String { plain("help_setup") }
  static var helpStart: String { plain("help_start") }
  static var helpSuggest: String { plain("help_suggest") }
  static var helpWork: String { plain("help_work") }
  static var holdAside: String { plain("hold_aside") }
  static var howPitch: String { plain("how_pitch") }
  static var howRoll: String { plain("how_roll") }
  static var howSurge: String { plain("how_surge") }
  static var howSway: String { plain("how_sway") }
  static var howToHang: String { plain("how_to_hang") }
  static var howYaw: String { plain("how_yaw") }
  static var hullPitchDeg: String { plain("hull_pitch_deg") }
  static var intervals: String { plain("intervals") }
  static var iosLicences: String { plain("ios_licences") }
  static var kYawShift: String { plain("k_yaw_shift") }
  static var kindOtherTurn: String { plain("kind_other_turn") }
  static var kindSameTurn: String { plain("kind_same_turn") }
  static var kindSway: String { plain("kind_sway") }
  static var knownCloser: String { plain("known_closer") }
  static var knownCloserSays: String { plain("known_closer_says") }
  static var leastDurationS: String { plain("least_duration_s") }
  static var leastLineM: String { plain("least_line_m") }
  static var leastSpacingM: String { plain("least_spacing_m") }
  static var libraryLanguage: String { plain("library_language") }
  static var licences: String { plain("licences") }
  static var limit: String { plain("limit") }
  static var limitAdd: String { plain("limit_add") }
  static func limitIs(_ first: String, _ second: String, _ third: String, _ fourth: String) -> String { filled("limit_is", first, second, third, fourth) }
  static var limitJudge: String { plain("limit_judge") }
  static var limitLeast: String { plain("limit_least") }
  static var limitMost: String { plain("limit_most") }
  static func limitProbability(_ first: Double) -> String { filled("limit_probability", first) }
  static var limitRemove: String { plain("limit_remove") }
  static var lineLengthM: String { plain("line_length_m") }
  static func mS2(_ first: Double) -> String { filled("m_s2", first) }
  static var measure: String { plain("measure") }
  static var measuredAgain: String { plain("measured_again") }
  static func metresShift(_ first: Double) -> String { filled("metres_shift", first) }
  static func minutes(_ first: Double) -> String { filled("minutes", first) }
  static var modeCompound: String { plain("mode_compound") }
  static var modeOther: String { plain("mode_other") }
  static func modePeriod(_ first: String, _ second: Double) -> String { filled("mode_period", first, second) }
  static var modePitchInPhase: String { plain("mode_pitch_in_phase") }
  static var modePitchOutOfPhase: String { plain("mode_pitch_out_of_phase") }
  static var modeRollInPhase: String { plain("mode_roll_in_phase") }
  static var modeRollOutOfPhase: String { plain("mode_roll_out_of_phase") }
  static var modeSway: String { plain("mode_sway") }
  static var modeYaw: String { plain("mode_yaw") }
  static var mostDurationS: String { plain("most_duration_s") }
  static var mostLineM: String { plain("most_line_m") }
  static var mostSpacingM: String { plain("most_spacing_m") }
  static var motionPitch: String { plain("motion_pitch") }
  static var motionRoll: String { plain("motion_roll") }
  static var motionSurge: String { plain("motion_surge") }
  static var motionSway: String { plain("motion_sway") }
  static var motionYaw: String { plain("motion_yaw") }
  static var moving: String { plain("moving") }
  static func movingBy(_ first: Double, _ second: Double) -> String { filled("moving_by", first, second) }
  static var nextSwing: String { plain("next_swing") }
  static func noSamples(_ first: String) -> String { filled("no_samples", first) }
  static var notDetermined: String { plain("not_determined") }
  static var notReached: String { plain("not_reached") }
  static func ofSeconds(_ first: Double, _ second: Double) -> String { filled("of_seconds", first, second) }
  static var otherWays: String { plain("other_ways") }
  static func percentDone(_ first: Double) -> String { filled("percent_done", first) }
  static var period: String { plain("period") }
  static var periodsExpected: String { plain("periods_expected") }
  static var phaseCritique: String { plain("phase_critique") }
  static var phaseDone: String { plain("phase_done") }
  static var phaseFailed: String { plain("phase_failed") }
  static var phaseHang: String { plain("phase_hang") }
  static var phaseInterrupted: String { plain("phase_interrupted") }
  static var phaseJudge: String { plain("phase_judge") }
  static var phaseLevel: String { plain("phase_level") }
  static var phaseMeasure: String { plain("phase_measure") }
  static var phaseReady: String { plain("phase_ready") }
  static var phaseRecord: String { plain("phase_record") }
  static var phaseRest: String { plain("phase_rest") }
  static var phaseStart: String { plain("phase_start") }
  static var phaseSuggest: String { plain("phase_suggest") }
  static var placement: String { plain("placement") }
  static var placementAny: String { plain("placement_any") }
  static var placementFlat: String { plain("placement_flat") }
  static var plan: String { plain("plan") }
  static var pointsMovedM: String { plain("points_moved_m") }
  static var portDown: String { plain("port_down") }
  static var practiceBanner: String { plain("practice_banner") }
  static var practiceGoOn: String { plain("practice_go_on") }
  static var practiceTitle: String { plain("practice_title") }
  static var practise: String { plain("practise") }
  static func quantityU(_ first: String, _ second: String, _ third: String) -> String { filled("quantity_u", first, second, third) }
  static func rateAbout(_ first: String) -> String { filled("rate_about", first) }
  static func rateAndGaps(_ first: Double, _ second: Int) -> String { filled("rate_and_gaps", first, second) }
  static func rateGaps(_ first: String, _ second: Double, _ third: Int, _ fourth: Double) -> String { filled("rate_gaps", first, second, third, fourth) }
  static var rateHz: String { plain("rate_hz") }
  static func rateNoGaps(_ first: String, _ second: Double) -> String { filled("rate_no_gaps", first, second) }
  static var reached: String { plain("reached") }
  static var recommendAccept: String { plain("recommend_accept") }
  static var recommendRepeat: String { plain("recommend_repeat") }
  static var recorded: String { plain("recorded") }
  static var recordings: String { plain("recordings") }
  static var releaseDeg: String { plain("release_deg") }
  static var report: String { plain("report") }
  static var reportPrint: String { plain("report_print") }
  static var reportShare: String { plain("report_share") }
  static var residualAfter: String { plain("residual_after") }
  static var residualBefore: String { plain("residual_before") }
  static var residualSays: String { plain("residual_says") }
  static var routes: String { plain("routes") }
  static var runsFor: String { plain("runs_for") }
  static func seconds(_ first: Double) -> String { filled("seconds", first) }
  static func secondsU(_ first: String, _ second: String) -> String { filled("seconds_u", first, second) }
  static var sensorStoppedAccelerometer: String { plain("sensor_stopped_accelerometer") }
  static var sensorStoppedGyroscope: String { plain("sensor_stopped_gyroscope") }
  static var sensors: String { plain("sensors") }
  static func sessionDamaged(_ first: String) -> String { filled("session_damaged", first) }
  static var sessionDelete: String { plain("session_delete") }
  static func sessionDeleted(_ first: String) -> String { filled("session_deleted", first) }
  static var sessionFromFile: String { plain("session_from_file") }
  static var sessionGoOn: String { plain("session_go_on") }
  static var sessionOpen: String { plain("session_open") }
  static var sessionShare: String { plain("session_share") }
  static var sessionUntitled: String { plain("session_untitled") }
  static var sessions: String { plain("sessions") }
  static var sessionsImport: String { plain("sessions_import") }
  static var sessionsNone: String { plain("sessions_none") }
  static var sketchAnyWay: String { plain("sketch_any_way") }
  static var sketchAthwartships: String { plain("sketch_athwartships") }
  static var sketchAxis: String { plain("sketch_axis") }
  static var sketchAxisHeight: String { plain("sketch_axis_height") }
  static var sketchBubble: String { plain("sketch_bubble") }
  static var sketchCompound: String { plain("sketch_compound") }
  static var sketchEllipsoid: String { plain("sketch_ellipsoid") }
  static var sketchFlat: String { plain("sketch_flat") }
  static var sketchForeAndAft: String { plain("sketch_fore_and_aft") }
  static var sketchFrame: String { plain("sketch_frame") }
  static var sketchLength: String { plain("sketch_length") }
  static var sketchPitch: String { plain("sketch_pitch") }
  static var sketchRoll: String { plain("sketch_roll") }
  static var sketchSpacing: String { plain("sketch_spacing") }
  static var sketchSurge: String { plain("sketch_surge") }
  static var sketchSway: String { plain("sketch_sway") }
  static var sketchYaw: String { plain("sketch_yaw") }
  static var sound: String { plain("sound") }
  static var soundOff: String { plain("sound_off") }
  static var soundOn: String { plain("sound_on") }
  static var spacingM: String { plain("spacing_m") }
  static var starboardDown: String { plain("starboard_down") }
  static var statusAdequate: String { plain("status_adequate") }
  static var statusAmbiguous: String { plain("status_ambiguous") }
  static var statusExplained: String { plain("status_explained") }
  static var statusUnexplained: String { plain("status_unexplained") }
  static func stepOf(_ first: Int, _ second: Int) -> String { filled("step_of", first, second) }
  static var swings: String { plain("swings") }
  static func take(_ first: Int) -> String { filled("take", first) }
  static var tilt: String { plain("tilt") }
  static func timesNoise(_ first: Double) -> String { filled("times_noise", first) }
  static var toGo: String { plain("to_go") }
  static var toTheBoat: String { plain("to_the_boat") }
  static var topSpacingM: String { plain("top_spacing_m") }
  static var trace: String { plain("trace") }
  static var type: String { plain("type") }
  static var typeDinghy: String { plain("type_dinghy") }
  static var typeKeelboat: String { plain("type_keelboat") }
  static var typeModelKeelboat: String { plain("type_model_keelboat") }
  static var typeUniformBar: String { plain("type_uniform_bar") }
  static var uLevelDeg: String { plain("u_level_deg") }
  static var uLineM: String { plain("u_line_m") }
  static var uSpacingM: String { plain("u_spacing_m") }
  static var undo: String { plain("undo") }
  static var unwanted: String { plain("unwanted") }
  static var unwantedNone: String { plain("unwanted_none") }
  static func unwantedOne(_ first: String, _ second: Double, _ third: Double) -> String { filled("unwanted_one", first, second, third) }
  static var verdictFail: String { plain("verdict_fail") }
  static var verdictPass: String { plain("verdict_pass") }
  static var verdictUndecided: String { plain("verdict_undecided") }
  static var versionApp: String { plain("version_app") }
  static var versionLibrary: String { plain("version_library") }
  static var wanted: String { plain("wanted") }
  static var wantedSays: String { plain("wanted_says") }
  static var weightKg: String { plain("weight_kg") }
  static var whatToMeasure: String { plain("what_to_measure") }
  static var whatToMeasureSays: String { plain("what_to_measure_says") }
  static var wholeResult: String { plain("whole_result") }
}
