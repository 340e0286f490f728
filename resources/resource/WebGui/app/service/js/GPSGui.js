// SPDX-License-Identifier: Apache-2.0
// Panel of the GPS service. MyRobotLab loads this script by its name. The panel's code is in modules loaded later.
angular.module('mrlapp.service.GPSGui', []).controller('GPSGuiCtrl', ['$scope', '$timeout', function($scope, $timeout) {
    var self = this
    import(new URL('service/js/sear/gps/panel.js', document.baseURI)).then(function(panel) {
        if (!$scope.$$destroyed) {
            panel.open(self, $scope, $timeout)
        }
    }).catch(function(error) {
        $scope.failed = 'This panel did not load: ' + error.message + '. Reinstall SEAR, then reload this page'
    }).then(function() {
        $scope.$applyAsync()
    })
}])
